#pragma once

#include <array>
#include <cerrno>
#include <stdexcept>
#include <string>
#include <system_error>

#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace test {

/// Listens on loopback, on a given port or one that the system chooses. Until `receive` is called, a
/// connection accepts only what the small socket buffers hold.
class Listener {
 public:
  explicit Listener(int port = 0) : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in in = {};
    in.sin_family = AF_INET;
    in.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    in.sin_port = htons(static_cast<in_port_t>(port));
    auto* address = reinterpret_cast<sockaddr*>(&in);
    socklen_t size = sizeof(in);
    const int buffer = 4096;
    ::setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &buffer, sizeof(buffer));
    if (socket_ < 0 || ::bind(socket_, address, size) != 0 || ::listen(socket_, 1) != 0 ||
        ::getsockname(socket_, address, &size) != 0) {
      throw std::system_error(errno, std::generic_category(), "cannot listen");
    }
    port_ = std::to_string(ntohs(in.sin_port));
  }
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;
  ~Listener() { ::close(socket_); }

  const std::string& port() const { return port_; }

  /// Accepts the next connection and returns its socket, which the caller closes.
  int accept() const { return ::accept(socket_, nullptr, nullptr); }

  /// Receives all bytes of one connection.
  std::string receive() const {
    const int connection = accept();
    std::string bytes;
    std::array<char, 65536> part = {};
    ssize_t count = 0;
    while ((count = ::recv(connection, part.data(), part.size(), 0)) > 0) {
      bytes.append(part.data(), static_cast<std::size_t>(count));
    }
    ::close(connection);
    return bytes;
  }

 private:
  int socket_;
  std::string port_;
};

/// Returns a port without a listener. It is outside Linux' range of ephemeral ports, so no other program is
/// given it.
inline int free_port() {
  constexpr int First = 16384;
  constexpr int Count = 16384;
  for (int i = 0; i < Count; ++i) {
    const int port = First + (::getpid() + 97 * i) % Count;
    try {
      const Listener listener(port);
      return port;
    } catch (const std::system_error&) {
      continue;
    }
  }
  throw std::runtime_error("no port is free");
}

}  // namespace test
