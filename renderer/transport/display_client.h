#pragma once

#include <atomic>
#include <chrono>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "renderer/transport/render.h"

namespace transport {

struct DisplayAddress {
  std::string host = "127.0.0.1";
  std::string port = "14158";

  std::string text() const { return host + ":" + port; }
};

/// `HOST:PORT`, `HOST`, `:PORT`, or `[HOST]:PORT` for one with colons in it; what is left out is tev's own
/// address on this machine. Nothing if that is no address.
std::optional<DisplayAddress> display_address_of(std::string_view text);

/// Shows a render as it forms in a viewer that speaks tev's protocol. It looks at the render from a thread of
/// its own, and sends the tiles that have changed: a slow viewer gets fewer of the states between, and the
/// render waits for nothing. When the viewer is gone, that is the end of it.
class DisplayClient {
 public:
  /// The render must outlive the client.
  DisplayClient(const Render& render, DisplayAddress address, std::string image_name);
  DisplayClient(const DisplayClient&) = delete;
  DisplayClient& operator=(const DisplayClient&) = delete;
  /// Leaves what was not sent.
  ~DisplayClient();

  /// To be called once the render has ended: sends what is left, for at most as long.
  void finish(std::chrono::milliseconds time = std::chrono::seconds(2));

  /// What went wrong, once: no viewer there, or gone.
  std::optional<std::string> take_problem();

 private:
  void run();
  bool connect();
  bool send(std::string_view bytes);
  bool send_changes();
  bool send_row(int row);
  bool is_out_of_time() const;
  void fail(const std::string& why);

  const Render& render_;
  const DisplayAddress address_;
  const std::string name_;
  std::vector<std::uint32_t> sent_;  ///< how many samples each tile had when it was sent
  int socket_ = -1;
  std::atomic<bool> finishes_ = false;
  /// Since the clock's epoch; when to give up.
  std::atomic<std::chrono::steady_clock::duration> deadline_ = std::chrono::steady_clock::duration::max();
  std::mutex problem_lock_;
  std::optional<std::string> problem_;
  std::thread thread_;  ///< the last member: it uses the others
};

}  // namespace transport
