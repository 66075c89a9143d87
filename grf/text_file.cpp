#include "grf/text_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

namespace grf {
namespace {

/// A file descriptor that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int value) : value_(value) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (value_ >= 0) ::close(value_);
  }
  int value() const { return value_; }
  /// Closing can report an error that writing did not.
  bool close() {
    const int closed = ::close(value_);
    value_ = -1;
    return closed == 0;
  }

 private:
  int value_;
};

std::string reason() { return std::generic_category().message(errno); }

std::string what_it_is(const struct stat& status) {
  if (S_ISDIR(status.st_mode)) return "a directory";
  if (S_ISFIFO(status.st_mode)) return "a pipe";
  return "a device or socket";
}

std::shared_ptr<std::string> read_all(int descriptor, std::size_t size) {
  auto bytes = std::make_shared<std::string>(size, '\0');
  std::size_t done = 0;
  while (done < size) {
    const ssize_t count = ::read(descriptor, bytes->data() + done, size - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return nullptr;
    if (count == 0) break;
    done += static_cast<std::size_t>(count);
  }
  bytes->resize(done);
  return bytes;
}

bool write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

}  // namespace

std::shared_ptr<const std::string> read_file(const std::string& path, Diagnostics& diagnostics,
                                             const SourceLocation& asked_for_at) {
  const auto fail = [&](const std::string& why) {
    const SourceLocation place = asked_for_at.file ? asked_for_at : whole_file(path);
    diagnostics.error(place, asked_for_at.file ? fmt::format("cannot read '{}': {}", path, why)
                                               : fmt::format("cannot read the file: {}", why));
    return nullptr;
  };
  // Without O_NONBLOCK, opening a pipe that nobody writes to would wait for ever.
  Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  struct stat status = {};
  if (file.value() < 0 || ::fstat(file.value(), &status) != 0) return fail(reason());
  if (!S_ISREG(status.st_mode)) {
    return fail(fmt::format("it is {}, a file was expected", what_it_is(status)));
  }
  auto bytes = read_all(file.value(), static_cast<std::size_t>(status.st_size));
  return bytes ? std::shared_ptr<const std::string>(std::move(bytes)) : fail(reason());
}

bool replace_file(const std::string& path, std::string_view bytes, Diagnostics& diagnostics) {
  // Through a symbolic link, the file that it points to is the one to replace.
  const std::string target = canonical_path(path);
  std::string temporary = target + ".XXXXXX";
  const auto fail = [&](const char* what) {
    diagnostics.error(whole_file(path), fmt::format("cannot {}: {}", what, reason()));
    return false;
  };
  struct stat old = {};
  const bool replaces = ::stat(target.c_str(), &old) == 0;
  if (replaces && !S_ISREG(old.st_mode)) {
    diagnostics.error(whole_file(path), fmt::format("cannot write the file: it is {}", what_it_is(old)));
    return false;
  }
  Descriptor file(::mkostemp(temporary.data(), O_CLOEXEC));
  if (file.value() < 0) return fail("create the file");
  // mkstemp gives a file that only its owner may read; the new one is to be like the old, or like any other.
  const mode_t mask = ::umask(0);
  ::umask(mask);
  ::fchmod(file.value(), replaces ? old.st_mode & 0777U : 0666U & ~mask);
  const bool written = write_all(file.value(), bytes) && ::fsync(file.value()) == 0 && file.close() &&
                       ::rename(temporary.c_str(), target.c_str()) == 0;
  if (!written) {
    const int why = errno;
    ::unlink(temporary.c_str());
    errno = why;
    return fail("write the file");
  }
  return true;
}

std::string path_beside(const std::string& naming_file, std::string_view name) {
  std::string portable(name);
  std::replace(portable.begin(), portable.end(), '\\', '/');
  return (std::filesystem::path(naming_file).parent_path() / portable).lexically_normal().string();
}

std::string canonical_path(const std::string& path) {
  std::error_code error;
  const std::filesystem::path exact = std::filesystem::weakly_canonical(path, error);
  return error || exact.empty() ? path : exact.string();
}

}  // namespace grf
