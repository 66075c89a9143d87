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

#include "renderer/display/address.h"
#include "renderer/transport/render.h"

namespace display {

/// Starts a viewer on the first call and watches it on the later ones: returns what prevents it from running,
/// or nothing if all is well.
using ViewerLauncher = std::function<std::optional<std::string>()>;

/// Shows a running render in a viewer that speaks tev's protocol. A thread of its own watches the render and
/// sends changed tiles: a slow viewer receives fewer intermediate states, and the render never waits. The
/// client ends when the viewer disconnects.
class Client {
 public:
  /// The render must outlive the client. If nobody listens, `viewer_launcher` can start a viewer: the
  /// client's thread calls it periodically until the viewer listens.
  Client(const transport::Render& render, Address address, std::string image_name,
         ViewerLauncher viewer_launcher = {});
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;
  /// Discards what was not sent.
  ~Client();

  /// Sends what is left, within the given time; to be called once the render has ended.
  void finish(std::chrono::milliseconds time = std::chrono::seconds(2));

  /// Whether it is still unknown if a viewer listens: one that was just started takes some seconds, which the
  /// end of a render does not wait for.
  bool is_connecting() const { return is_connecting_; }

  /// Returns what went wrong, once: there is no viewer, or the connection was lost.
  std::optional<std::string> take_problem();

 private:
  void run();
  std::optional<std::string> connect();
  std::optional<std::string> connect_to_host();
  std::optional<std::string> connect_to_path();
  bool connect_to_any();
  bool send(std::string_view bytes);
  bool send_changes();
  bool send_row(int row);
  bool is_out_of_time() const;
  void fail(const std::string& why);

  const transport::Render& render_;
  const Address address_;
  const std::string name_;
  const ViewerLauncher viewer_launcher_;
  std::vector<std::uint32_t> sent_;  ///< per tile: the number of samples when it was last sent
  int socket_ = -1;
  std::atomic<bool> is_connecting_ = true;
  std::atomic<bool> finishes_ = false;
  /// The time at which to give up, since the clock's epoch.
  std::atomic<std::chrono::steady_clock::duration> deadline_ = std::chrono::steady_clock::duration::max();
  std::mutex problem_lock_;
  std::optional<std::string> problem_;
  std::thread thread_;  ///< last member, because it uses the others
};

}  // namespace display
