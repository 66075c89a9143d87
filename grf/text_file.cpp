#include "grf/text_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <deque>
#include <filesystem>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "grf/keywords.h"

namespace grf {
namespace {

constexpr std::string_view TemporaryExtension = ".new";

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

/// Returns the reason for an error of opening a file to read. A process may be confined to other folders than
/// its user.
std::string reason_of_reading(const std::string& path) {
  const std::string usual = reason();
  return errno == EACCES && ::faccessat(AT_FDCWD, path.c_str(), R_OK, AT_EACCESS) == 0
             ? "it is outside of the folders that are read"
             : usual;
}

std::string what_it_is(const struct stat& status) {
  if (S_ISDIR(status.st_mode)) return "a directory";
  if (S_ISFIFO(status.st_mode)) return "a pipe";
  return "a device or socket";
}

/// A regular file opened for reading.
class FileToRead {
 public:
  // Without O_NONBLOCK, opening a pipe without a writer would block forever.
  explicit FileToRead(const std::string& path)
      : path_(path), file_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
    is_open_ = file_.value() >= 0 && ::fstat(file_.value(), &status_) == 0;
  }

  /// Returns all of its bytes, as they were at one time; null after an error.
  std::shared_ptr<const std::string> bytes() {
    if (!is_regular()) return nullptr;
    auto bytes = read_all();
    has_changed_ = bytes && was_written_to();
    return has_changed_ ? nullptr : bytes;
  }

  /// Reports why it cannot be read, at the location that asked for it or at the file itself.
  std::string problem(const SourceLocation& asked_for_at) const {
    const std::string why = has_changed_ ? "it was changed while it was read"
                            : is_open_ && !is_regular()
                                ? fmt::format("it is {}, expected a file", what_it_is(status_))
                                : reason_of_reading(path_);
    return asked_for_at.file ? fmt::format("cannot read '{}': {}", path_, why)
                             : fmt::format("cannot read the file: {}", why);
  }

 private:
  bool is_regular() const { return is_open_ && S_ISREG(status_.st_mode); }

  std::shared_ptr<const std::string> read_all() const {
    const auto size = static_cast<std::size_t>(status_.st_size);
    auto bytes = std::make_shared<std::string>(size, '\0');
    std::size_t done = 0;
    while (done < size) {
      const ssize_t count = ::read(file_.value(), bytes->data() + done, size - done);
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) return nullptr;
      if (count == 0) break;
      done += static_cast<std::size_t>(count);
    }
    bytes->resize(done);
    return bytes;
  }

  // The modification time tells, with a resolution of some milliseconds.
  bool was_written_to() const {
    struct stat now = {};
    if (::fstat(file_.value(), &now) != 0) return false;
    return now.st_size != status_.st_size || now.st_mtim.tv_sec != status_.st_mtim.tv_sec ||
           now.st_mtim.tv_nsec != status_.st_mtim.tv_nsec;
  }

  std::string path_;
  Descriptor file_;
  struct stat status_ = {};
  bool is_open_ = false;
  bool has_changed_ = false;
};

bool write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

/// Creates a file with a unique name. Unlike mkstemp, it has the permissions of any new file; to read them
/// from the umask would mean to change the umask, which affects other threads.
int create_beside(const std::string& target, mode_t mode, std::string& path) {
  for (unsigned attempt = 0;; ++attempt) {
    path = fmt::format("{}.{}-{}{}", target, ::getpid(), attempt, TemporaryExtension);
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    if (descriptor >= 0 || errno != EEXIST) return descriptor;
  }
}

/// A temporary file that is to replace another one; it is removed unless it does.
class Replacement {
 public:
  Replacement(const std::string& path, Diagnostics& diagnostics)
      // Through a symbolic link, the file that it points to is the one to replace.
      : path_(path), target_(canonical_path(path)), diagnostics_(diagnostics) {}
  Replacement(const Replacement&) = delete;
  Replacement& operator=(const Replacement&) = delete;
  ~Replacement() {
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
  }

  /// Creates and writes the temporary file beside the other one.
  bool prepare(const std::function<bool(const FileWriter& write)>& fill) {
    struct stat old = {};
    const bool replaces = ::stat(target_.c_str(), &old) == 0;
    if (replaces && !S_ISREG(old.st_mode)) {
      diagnostics_.error(whole_file(path_), fmt::format("cannot write the file: it is {}", what_it_is(old)));
      return false;
    }
    // Renaming needs only write access to the folder, but a read-only file is to stay unchanged.
    const bool may_write = !replaces || ::faccessat(AT_FDCWD, target_.c_str(), W_OK, AT_EACCESS) == 0;
    if (!may_write) return fail("write the file");
    std::string temporary;
    Descriptor file(create_beside(target_, replaces ? 0600 : 0666, temporary));
    if (file.value() < 0) return fail("create the file");
    temporary_ = temporary;
    const bool written = (!replaces || ::fchmod(file.value(), old.st_mode & 0777U) == 0) &&
                         fill([&](std::string_view bytes) { return write_all(file.value(), bytes); }) &&
                         ::fsync(file.value()) == 0 && file.close();
    return written || fail("write the file");
  }

  bool take_place() {
    if (::rename(temporary_.c_str(), target_.c_str()) != 0) return fail("write the file");
    temporary_.clear();
    return true;
  }

 private:
  bool fail(const char* what) {
    diagnostics_.error(whole_file(path_), fmt::format("cannot {}: {}", what, reason()));
    return false;
  }

  std::string path_;
  std::string target_;
  Diagnostics& diagnostics_;
  std::string temporary_;
};

}  // namespace

std::shared_ptr<const std::string> read_file(const std::string& path, Diagnostics& diagnostics,
                                             const SourceLocation& asked_for_at) {
  FileToRead file(path);
  auto bytes = file.bytes();
  if (!bytes)
    diagnostics.error(asked_for_at.file ? asked_for_at : whole_file(path), file.problem(asked_for_at));
  else
    diagnostics.add_file(path);
  return bytes;
}

bool replace_file(const std::string& path, std::string_view bytes, Diagnostics& diagnostics) {
  return replace_file(
      path, [bytes](const FileWriter& write) { return write(bytes); }, diagnostics);
}

bool replace_file(const std::string& path, const std::function<bool(const FileWriter& write)>& fill,
                  Diagnostics& diagnostics) {
  return replace_files(std::vector{NewFile{path, fill}}, diagnostics);
}

bool replace_files(const std::vector<NewFile>& files, Diagnostics& diagnostics) {
  std::deque<Replacement> replacements;
  for (const NewFile& file : files) {
    if (!replacements.emplace_back(file.path, diagnostics).prepare(file.fill)) return false;
  }
  return std::all_of(replacements.begin(), replacements.end(),
                     [](Replacement& replacement) { return replacement.take_place(); });
}

Creation create_file(const std::string& path, std::string_view bytes, Diagnostics& diagnostics) {
  const std::string target = canonical_path(path);
  const auto fail = [&](const char* what) {
    diagnostics.error(whole_file(path), fmt::format("cannot {}: {}", what, reason()));
    return Creation::Failed;
  };
  struct stat old = {};
  if (::lstat(target.c_str(), &old) == 0) return Creation::Exists;
  std::string temporary;
  Descriptor file(create_beside(target, 0666, temporary));
  if (file.value() < 0) return fail("create the file");
  const bool written = write_all(file.value(), bytes) && ::fsync(file.value()) == 0 && file.close();
  // Unlike renaming, linking fails if the file exists by now; FAT has no links.
  const bool created = written && (::link(temporary.c_str(), target.c_str()) == 0 ||
                                   (errno == EPERM && ::rename(temporary.c_str(), target.c_str()) == 0));
  const int why = errno;
  ::unlink(temporary.c_str());
  errno = why;
  if (created) return Creation::Done;
  return written && why == EEXIST ? Creation::Exists : fail("write the file");
}

void remove_temporary_files(const std::string& folder, int process) {
  const std::string mark = fmt::format(".{}-", process);
  std::error_code error;
  std::vector<std::filesystem::path> left;
  for (std::filesystem::directory_iterator entry(folder, error);
       !error && entry != std::filesystem::end(entry); entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    const std::size_t at = name.rfind(mark);
    const bool is_one =
        at != std::string::npos && name.ends_with(TemporaryExtension) &&
        name.find_first_not_of("0123456789", at + mark.size()) == name.size() - TemporaryExtension.size();
    if (is_one) left.push_back(entry->path());
  }
  for (const std::filesystem::path& path : left) std::filesystem::remove(path, error);
}

std::string path_beside(const std::string& naming_file, std::string_view name) {
  std::string portable(name);
  std::replace(portable.begin(), portable.end(), '\\', '/');
  return (std::filesystem::path(naming_file).parent_path() / portable).lexically_normal().string();
}

std::string file_name(const std::string& path) { return std::filesystem::path(path).filename().string(); }

bool is_igrf_name(const std::string& path) {
  return same_keyword(std::filesystem::path(path).extension().string(), ".igrf");
}

std::string canonical_path(const std::string& path) {
  std::error_code error;
  const std::filesystem::path absolute = std::filesystem::absolute(path, error);
  if (error) return path;
  const std::filesystem::path exact = std::filesystem::weakly_canonical(absolute, error);
  return error || exact.empty() ? path : exact.string();
}

}  // namespace grf
