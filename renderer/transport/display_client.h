#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "renderer/transport/display_address.h"
#include "renderer/transport/render.h"

namespace transport {

/// Starts a viewer when it is called first, and looks after it at each further call: says what is in its way,
/// or nothing if all is well.
using ViewerCare = std::function<std::optional<std::string>()>;

/// Shows a render as it forms in a viewer that speaks tev's protocol. It looks at the render from a thread of
/// its own, and sends the tiles that have changed: a slow viewer gets fewer of the states between, and the
/// render waits for nothing. When the viewer is gone, that is the end of it.
class DisplayClient {
 public:
  /// The render must outlive the client. Where nobody listens, a viewer can be started: `viewer_care` is
  /// called in the client's thread, from time to time, until the viewer listens.
  DisplayClient(const Render& render, DisplayAddress address, std::string image_name,
                ViewerCare viewer_care = {});
  DisplayClient(const DisplayClient&) = delete;
  DisplayClient& operator=(const DisplayClient&) = delete;
  /// Leaves what was not sent.
  ~DisplayClient();

  /// To be called once the render has ended: sends what is left, for at most as long.
  void finish(std::chrono::milliseconds time = std::chrono::seconds(2));

  /// Whether it has not turned out yet if there is a viewer: one that is started takes some seconds, and that
  /// is not waited for at the end.
  bool is_connecting() const { return is_connecting_; }

  /// What went wrong, once: no viewer there, or gone.
  std::optional<std::string> take_problem();

 private:
  void run();
  std::optional<std::string> connect();
  bool connect_to_any();
  bool send(std::string_view bytes);
  bool send_changes();
  bool send_row(int row);
  bool is_out_of_time() const;
  void fail(const std::string& why);

  const Render& render_;
  const DisplayAddress address_;
  const std::string name_;
  const ViewerCare viewer_care_;
  std::vector<std::uint32_t> sent_;  ///< how many samples each tile had when it was sent
  int socket_ = -1;
  std::atomic<bool> is_connecting_ = true;
  std::atomic<bool> finishes_ = false;
  /// Since the clock's epoch; when to give up.
  std::atomic<std::chrono::steady_clock::duration> deadline_ = std::chrono::steady_clock::duration::max();
  std::mutex problem_lock_;
  std::optional<std::string> problem_;
  std::thread thread_;  ///< the last member: it uses the others
};

}  // namespace transport
