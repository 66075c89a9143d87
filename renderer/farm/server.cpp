#include "renderer/farm/server.h"

#include <cerrno>
#include <csignal>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "grf/text_file.h"

namespace farm {
namespace {

namespace fs = std::filesystem;

/// A larger message than by default, so that parts of large images fit into one.
constexpr int LargestMessage = 8 << 20;

/// The server's configuration, whose quoted texts are those of JSON.
std::string configuration_of(const ServerSettings& settings) {
  const auto quoted = [](const std::string& text) { return nlohmann::json(text).dump(); };
  const std::string store = fs::absolute(fs::path(settings.folder) / "jetstream").string();
  std::string text = fmt::format("host: {}\nport: {}\nmax_payload: {}\njetstream {{ store_dir: {} }}\n",
                                 quoted(settings.host), settings.port, LargestMessage, quoted(store));
  if (!settings.token.empty()) text += fmt::format("authorization {{ token: {} }}\n", quoted(settings.token));
  if (settings.tls_certificate.empty()) return text;
  text += fmt::format("tls {{\n  cert_file: {}\n  key_file: {}\n",
                      quoted(fs::absolute(settings.tls_certificate).string()),
                      quoted(fs::absolute(settings.tls_key).string()));
  if (!settings.tls_authority.empty()) {
    text +=
        fmt::format("  ca_file: {}\n  verify: true\n", quoted(fs::absolute(settings.tls_authority).string()));
  }
  return text + "}\n";
}

/// Becomes the server; to be called in a child process. Does not return.
[[noreturn]] void become_server(const std::string& configuration, int log) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // it is to end with its parent, however that ends
  ::setpgid(0, 0);                     // Ctrl-C is for the parent, which ends it
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  ::dup2(log, STDOUT_FILENO);
  ::dup2(log, STDERR_FILENO);
  ::execlp("nats-server", "nats-server", "--config", configuration.c_str(), static_cast<char*>(nullptr));
  ::_exit(127);
}

}  // namespace

bool is_loopback(const std::string& host) {
  return host == "localhost" || host == "::1" || host.starts_with("127.");
}

std::optional<Server> Server::start(const ServerSettings& settings, grf::Diagnostics& diagnostics) {
  const fs::path folder(settings.folder);
  std::error_code error;
  fs::create_directories(folder, error);
  const std::string configuration = (folder / "nats-server.conf").string();
  const std::string log_path = (folder / "nats-server.log").string();
  // The configuration has the token: nobody else may read it.
  const mode_t before = ::umask(077);
  const bool is_written = grf::replace_file(configuration, configuration_of(settings), diagnostics);
  const int log = ::open(log_path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
  ::umask(before);
  if (!is_written) return std::nullopt;
  const auto fail = [&](const std::string& what) {
    diagnostics.error(grf::whole_file(log_path), what);
    return std::nullopt;
  };
  if (log < 0) return fail(fmt::format("cannot write the log: {}", std::generic_category().message(errno)));
  const pid_t process = ::fork();
  if (process == 0) become_server(configuration, log);
  ::close(log);
  if (process < 0) return fail("cannot start nats-server: too many processes");
  Server server(process);
  // One that cannot start ends at once.
  ::usleep(200'000);
  if (server.is_running()) return server;
  return fail(
      "nats-server cannot start: it is not installed (Debian's package nats-server), or its log says why");
}

Server::Server(Server&& other) noexcept : process_(std::exchange(other.process_, 0)) {}

Server::~Server() {
  if (process_ == 0) return;
  ::kill(process_, SIGTERM);
  ::waitpid(process_, nullptr, 0);
}

bool Server::is_running() {
  if (process_ != 0 && ::waitpid(process_, nullptr, WNOHANG) == process_) process_ = 0;
  return process_ != 0;
}

}  // namespace farm
