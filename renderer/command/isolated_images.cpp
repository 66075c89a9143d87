#include "renderer/command/isolated_images.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "confinement/address_space.h"
#include "renderer/image/decoded_image.h"

namespace command {
namespace {

/// A file in memory that a process writes to, mapped once the process has ended.
class MemoryFile {
 public:
  MemoryFile() : descriptor_(::memfd_create("image", MFD_CLOEXEC)) {}
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() {
    if (size_ > 0) ::munmap(start_, size_);
    if (descriptor_ >= 0) ::close(descriptor_);
  }

  int descriptor() const { return descriptor_; }
  std::string_view bytes() {
    struct stat status = {};
    if (size_ == 0 && ::fstat(descriptor_, &status) == 0 && status.st_size > 0) {
      const auto size = static_cast<std::size_t>(status.st_size);
      void* start = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, descriptor_, 0);
      if (start == MAP_FAILED) return {};
      start_ = start;
      size_ = size;
    }
    return {static_cast<const char*>(start_), size_};
  }

 private:
  int descriptor_;
  void* start_ = nullptr;
  std::size_t size_ = 0;
};

/// A process that writes to files and has no input.
class ChildProcess {
 public:
  ChildProcess(const std::string& program, std::vector<std::string> words, int out, int err) {
    posix_spawn_file_actions_t files = {};
    ::posix_spawn_file_actions_init(&files);
    ::posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_adddup2(&files, out, STDOUT_FILENO);
    ::posix_spawn_file_actions_adddup2(&files, err, STDERR_FILENO);
    posix_spawnattr_t attributes = {};
    ::posix_spawnattr_init(&attributes);
    sigset_t signals;
    sigemptyset(&signals);
    ::posix_spawnattr_setsigmask(&attributes, &signals);
    // In a process group of its own: an interruption of the render by Ctrl+C is no fault of the image.
    ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETPGROUP);
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    problem_ = ::posix_spawn(&process_, program.c_str(), &files, &attributes, arguments.data(), environ);
    ::posix_spawnattr_destroy(&attributes);
    ::posix_spawn_file_actions_destroy(&files);
  }

  /// Why it could not be started; 0: it was.
  int problem() const { return problem_; }

  void limit_memory(std::uint64_t bytes) const {
    const rlimit memory = {bytes, bytes};
    ::prlimit(process_, RLIMIT_FSIZE, &memory, nullptr);
    if (confinement::CanLimitAddressSpace) ::prlimit(process_, RLIMIT_AS, &memory, nullptr);
    const rlimit none = {0, 0};
    ::prlimit(process_, RLIMIT_CORE, &none, nullptr);
  }

  /// Waits, and returns the status as of waitpid; nothing if it was killed after this time. Kernels before
  /// Linux 5.3 wait without end.
  std::optional<int> wait(double seconds) const {
    const auto file = static_cast<int>(::syscall(SYS_pidfd_open, process_, 0));
    bool is_late = false;
    if (file >= 0) {
      pollfd end = {file, POLLIN, 0};
      const double milliseconds = std::min(std::ceil(1000 * seconds), 1e9);
      int count = 0;
      do count = ::poll(&end, 1, static_cast<int>(milliseconds));
      while (count < 0 && errno == EINTR);
      is_late = count == 0;
      ::close(file);
    }
    if (is_late) ::kill(process_, SIGKILL);
    int status = 0;
    while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    return is_late ? std::nullopt : std::optional(status);
  }

 private:
  pid_t process_ = 0;
  int problem_ = 0;
};

constexpr std::string_view Prefix = "cannot read the image: ";

/// Returns the image, or nothing and the reason.
std::optional<image::Image> decode_in_child(const std::string& bpt, const std::string& path,
                                            image::Alpha alpha, const DecodingLimits& limits,
                                            std::string& why) {
  const auto fail = [&](std::string reason) {
    why = std::move(reason);
    return std::nullopt;
  };
  MemoryFile out;
  MemoryFile err;
  if (out.descriptor() < 0 || err.descriptor() < 0) return fail("it needs more memory than there is");
  const bool has_alpha = alpha == image::Alpha::Kept;
  std::vector<std::string> words = {"bpt", "decode"};
  if (has_alpha) words.emplace_back("--alpha");
  words.insert(words.end(), {"--", path});
  const ChildProcess process(bpt, words, out.descriptor(), err.descriptor());
  if (process.problem() != 0)
    return fail("its decoder cannot be started: " + std::generic_category().message(process.problem()));
  process.limit_memory(limits.memory);
  const std::optional<int> status = process.wait(limits.seconds);
  if (!status) return fail(fmt::format("decoding takes longer than {:g} s", limits.seconds));
  if (!WIFEXITED(*status)) return fail("it is damaged (its decoder crashed)");
  if (WEXITSTATUS(*status) != 0) {
    std::string_view said = err.bytes().substr(0, err.bytes().find('\n'));
    if (said.starts_with(Prefix)) said.remove_prefix(Prefix.size());
    return fail(std::string(said));
  }
  if (auto file = image::decoded_image(out.bytes(), has_alpha))
    return image::with_alpha_of_layer(std::move(*file));
  return fail("it is damaged (its decoder wrote no image)");
}

}  // namespace

image::ImageReader isolated_image_reader(const std::string& bpt, const DecodingLimits& limits) {
  return [bpt, limits](const std::string& path, grf::Diagnostics& diagnostics,
                       const grf::SourceLocation& asked_for_at,
                       image::Alpha alpha) -> std::optional<image::Image> {
    if (!image::is_decoded_by_library(path)) return image::read_image(path, diagnostics, asked_for_at, alpha);
    std::string why;
    auto image = decode_in_child(bpt, path, alpha, limits, why);
    if (image) {
      diagnostics.add_file(path);
    } else if (asked_for_at.file) {
      diagnostics.error(asked_for_at, fmt::format("cannot read the image '{}': {}", path, why));
    } else {
      diagnostics.error(grf::whole_file(path), fmt::format("{}{}", Prefix, why));
    }
    return image;
  };
}

}  // namespace command
