#include "renderer/command/image_viewer_process.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace command {
namespace {

constexpr const char* Name = "wannabe";

bool is_given(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

std::filesystem::path own_folder() {
  std::error_code none;
  return std::filesystem::read_symlink("/proc/self/exe", none).parent_path();
}

/// Attributes of a detached process: no terminal, no open files, no blocked signals.
class Detached {
 public:
  Detached() {
    ::posix_spawn_file_actions_init(&files_);
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
      ::posix_spawn_file_actions_addopen(&files_, stream, "/dev/null", O_RDWR, 0);
    }
    ::posix_spawn_file_actions_addclosefrom_np(&files_, STDERR_FILENO + 1);
    ::posix_spawnattr_init(&attributes_);
    sigset_t signals;
    sigemptyset(&signals);
    ::posix_spawnattr_setsigmask(&attributes_, &signals);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGCHLD}) sigaddset(&signals, signal);
    ::posix_spawnattr_setsigdefault(&attributes_, &signals);
    ::posix_spawnattr_setflags(&attributes_,
                               POSIX_SPAWN_SETSID | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }
  Detached(const Detached&) = delete;
  Detached& operator=(const Detached&) = delete;
  ~Detached() {
    ::posix_spawn_file_actions_destroy(&files_);
    ::posix_spawnattr_destroy(&attributes_);
  }

  const posix_spawn_file_actions_t* files() const { return &files_; }
  const posix_spawnattr_t* attributes() const { return &attributes_; }

 private:
  posix_spawn_file_actions_t files_ = {};
  posix_spawnattr_t attributes_ = {};
};

}  // namespace

std::optional<std::string> ImageViewerProcess::ensure_running() {
  return process_ == 0 ? start() : exit_reason();
}

std::optional<std::string> ImageViewerProcess::start() {
  if (!is_given("DISPLAY") && !is_given("WAYLAND_DISPLAY")) {
    return "there is no display: neither DISPLAY nor WAYLAND_DISPLAY is set";
  }
  const std::filesystem::path folder = own_folder();
  const std::string beside = (folder / Name).string();
  const Detached detached;
  std::array<std::string, 3> words = {Name, "--tool", "image"};
  const std::array<char*, 4> arguments = {words[0].data(), words[1].data(), words[2].data(), nullptr};
  int failure = ::posix_spawn(&process_, beside.c_str(), detached.files(), detached.attributes(),
                              arguments.data(), environ);
  if (failure == ENOENT) {
    failure =
        ::posix_spawnp(&process_, Name, detached.files(), detached.attributes(), arguments.data(), environ);
  }
  if (failure == 0) return std::nullopt;
  process_ = 0;
  if (failure == ENOENT) return fmt::format("`{}` is neither in {} nor in PATH", Name, folder.string());
  return fmt::format("`{}`: {}", Name, std::generic_category().message(failure));
}

std::optional<std::string> ImageViewerProcess::exit_reason() const {
  int status = 0;
  if (::waitpid(process_, &status, WNOHANG) != process_) return std::nullopt;
  return WIFEXITED(status) ? fmt::format("`{}` exited with code {}", Name, WEXITSTATUS(status))
                           : fmt::format("`{}` was killed by signal {}", Name, WTERMSIG(status));
}

}  // namespace command
