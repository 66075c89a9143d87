#include "renderer/display/client.h"

#include <cerrno>
#include <memory>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include "renderer/display/packets.h"
#include "renderer/image/image.h"

namespace display {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

/// Interval between two looks at the render.
constexpr milliseconds Pause(50);
/// Interval at which a wait checks whether it has become pointless.
constexpr milliseconds Step(20);
/// The most tiles that are sent as one rectangle: 100 KB.
constexpr int LongestRun = 32;
/// Timeout for a viewer's answer.
constexpr milliseconds ConnectTime(3000);
/// Timeout for a viewer that was just started to listen.
constexpr milliseconds StartTime(10000);

std::string reason() { return std::generic_category().message(errno); }

/// Whether the socket becomes writable within a step.
bool is_writable(int socket) {
  pollfd wait = {socket, POLLOUT, 0};
  return ::poll(&wait, 1, static_cast<int>(Step.count())) > 0;
}

struct FreeAddresses {
  void operator()(addrinfo* addresses) const { ::freeaddrinfo(addresses); }
};

}  // namespace

Client::Client(const transport::Render& render, Address address, std::string image_name,
               ViewerLauncher viewer_launcher)
    : render_(render),
      address_(std::move(address)),
      name_(std::move(image_name)),
      viewer_launcher_(std::move(viewer_launcher)),
      sent_(static_cast<std::size_t>(render.film().tile_count())),
      thread_([this] { run(); }) {}

Client::~Client() {
  finish(milliseconds(0));
  if (socket_ >= 0) ::close(socket_);
}

void Client::finish(milliseconds time) {
  if (!thread_.joinable()) return;
  deadline_ = (Clock::now() + time).time_since_epoch();
  finishes_ = true;
  thread_.join();
}

std::optional<std::string> Client::take_problem() {
  const std::lock_guard lock(problem_lock_);
  return std::exchange(problem_, std::nullopt);
}

bool Client::is_out_of_time() const { return Clock::now().time_since_epoch() >= deadline_.load(); }

void Client::fail(const std::string& why) {
  const std::lock_guard lock(problem_lock_);
  problem_ = why;
}

void Client::run() {
  const bool is_connected = connect_to_any();
  is_connecting_ = false;
  if (!is_connected) return;
  // A viewer that still has an image of that name from an earlier render would keep showing it.
  bool goes_on = send(close_image_packet(name_)) &&
                 send(create_image_packet(name_, render_.settings().width, render_.settings().height));
  while (goes_on) {
    const bool is_last = finishes_;  // what changes from now on is sent in the next round
    goes_on = send_changes() && !is_last;
    for (auto waited = milliseconds(0); goes_on && !finishes_ && waited < Pause; waited += Step) {
      std::this_thread::sleep_for(Step);
    }
  }
}

/// Connects to the viewer; returns what prevents it, or nothing on success.
std::optional<std::string> Client::connect() {
  return address_.path.empty() ? connect_to_host() : connect_to_path();
}

std::optional<std::string> Client::connect_to_path() {
  sockaddr_un address = {};
  address.sun_family = AF_UNIX;
  address_.path.copy(static_cast<char*>(address.sun_path), sizeof(address.sun_path) - 1);
  socket_ = ::socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (socket_ < 0) return reason();
  std::string why;
  ucred viewer = {};
  socklen_t size = sizeof(viewer);
  if (::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0 ||
      ::getsockopt(socket_, SOL_SOCKET, SO_PEERCRED, &viewer, &size) != 0) {
    why = reason();
  } else if (viewer.uid != ::geteuid()) {
    // In a folder where all may write, others could wait for the images of this user.
    why = "it belongs to another user";
  }
  if (why.empty()) return std::nullopt;
  ::close(std::exchange(socket_, -1));
  return why;
}

std::optional<std::string> Client::connect_to_host() {
  addrinfo hints = {};
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  const int failure = ::getaddrinfo(address_.host.c_str(), address_.port.c_str(), &hints, &found);
  const std::unique_ptr<addrinfo, FreeAddresses> addresses(found);
  std::string why = failure != 0 ? ::gai_strerror(failure) : "";
  for (const addrinfo* a = found; a != nullptr; a = a->ai_next) {
    socket_ = ::socket(a->ai_family, a->ai_socktype | SOCK_NONBLOCK | SOCK_CLOEXEC, a->ai_protocol);
    if (socket_ < 0) continue;
    int problem = ::connect(socket_, a->ai_addr, a->ai_addrlen) == 0 ? 0 : errno;
    if (problem == EINPROGRESS) {
      problem = ETIMEDOUT;
      for (auto waited = milliseconds(0); waited < ConnectTime && !is_out_of_time(); waited += Step) {
        socklen_t size = sizeof(problem);
        if (!is_writable(socket_)) continue;
        ::getsockopt(socket_, SOL_SOCKET, SO_ERROR, &problem, &size);
        break;
      }
    }
    if (problem == 0) return std::nullopt;
    why = std::generic_category().message(problem);
    ::close(std::exchange(socket_, -1));
  }
  return why;
}

/// Connects to a listening viewer, or else starts one.
bool Client::connect_to_any() {
  const std::optional<std::string> why = connect();
  if (!why) return true;
  if (!viewer_launcher_) {
    fail(fmt::format(
        "no viewer listens at {} ({}): to watch the render, start `wannabe --tool image` or another viewer "
        "that supports tev's protocol",
        address_.text(), *why));
    return false;
  }
  std::optional<std::string> problem = viewer_launcher_();
  const auto latest = Clock::now() + StartTime;
  while (!problem && !is_out_of_time()) {
    std::this_thread::sleep_for(Pause);
    if (!connect()) return true;
    problem = Clock::now() < latest ? viewer_launcher_() : "the viewer that was started does not answer";
  }
  if (problem) {
    fail(fmt::format("no viewer listens at {}, and none can be started ({}): rendering continues without one",
                     address_.text(), *problem));
  }
  return false;
}

bool Client::send(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (count >= 0) {
      bytes.remove_prefix(static_cast<std::size_t>(count));
    } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
      if (is_out_of_time()) return false;
      is_writable(socket_);
    } else if (errno != EINTR) {
      fail(fmt::format("connection to the viewer at {} lost ({}): rendering continues without it",
                       address_.text(), reason()));
      return false;
    }
  }
  return true;
}

bool Client::send_changes() {
  for (int row = 0; row < render_.film().tiles_down(); ++row) {
    if (is_out_of_time() || !send_row(row)) return false;
  }
  return true;
}

/// Sends each run of adjacent changed tiles as one rectangle.
bool Client::send_row(int row) {
  const int across = render_.film().tiles_across();
  transport::FilmTile tile;
  for (int first = row * across; first < (row + 1) * across; ++first) {
    const auto has_changed = [&](int i) {
      return render_.sample_count_of(i) != sent_[static_cast<std::size_t>(i)];
    };
    int last = first;
    while (last < (row + 1) * across && last - first < LongestRun && has_changed(last)) ++last;
    if (last == first) continue;
    const transport::TileBounds start = render_.film().bounds_of(first);
    const transport::TileBounds end = render_.film().bounds_of(last - 1);
    const transport::TileBounds bounds = {start.x, start.y, end.x + end.width - start.x, start.height};
    image::Image part{bounds.width, bounds.height, std::vector<grf::Colour>(bounds.pixel_count())};
    for (int i = first; i < last; ++i) {
      render_.copy_tile(i, tile);
      sent_[static_cast<std::size_t>(i)] = tile.sample_count();
      const transport::TileBounds place = {tile.bounds.x - bounds.x, 0, tile.bounds.width,
                                           tile.bounds.height};
      transport::write_tile(
          place, [&](std::size_t p) { return tile.mean(p); }, part);
    }
    if (!send(update_image_packet(name_, bounds, part.pixels))) return false;
    first = last - 1;
  }
  return true;
}

}  // namespace display
