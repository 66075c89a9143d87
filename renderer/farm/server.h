// A farm's nats-server runs as a child process.
#pragma once

#include <optional>
#include <string>

#include <sys/types.h>

#include "grf/diagnostics.h"

namespace farm {

struct ServerSettings {
  std::string folder;  ///< of what the server keeps
  std::string host = "127.0.0.1";
  int port = 4222;
  std::string token;            ///< that clients have to know; empty: none
  std::string tls_certificate;  ///< of the server; empty: connections are not encrypted
  std::string tls_key;
  std::string tls_authority;  ///< that has to have signed the clients' certificates; empty: they need none

  /// Whether only those who are allowed to can use the server.
  bool has_access_control() const { return !token.empty() || !tls_authority.empty(); }
};

/// Whether only programs of this machine can reach a server at this host.
bool is_loopback(const std::string& host);

/// A `nats-server`, which ends with this object, or with the process.
class Server {
 public:
  /// Starts a server. Its configuration and its log are in the folder, which is made if it does not exist.
  static std::optional<Server> start(const ServerSettings& settings, grf::Diagnostics& diagnostics);
  Server(Server&& other) noexcept;
  Server& operator=(Server&&) = delete;
  ~Server();

  /// Returns whether it still runs.
  bool is_running();

 private:
  explicit Server(pid_t process) : process_(process) {}

  pid_t process_ = 0;
};

}  // namespace farm
