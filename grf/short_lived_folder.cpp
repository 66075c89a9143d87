#include "grf/short_lived_folder.h"

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace grf {
namespace {

namespace fs = std::filesystem;

/// Longer than a process takes from making a folder to locking it.
constexpr std::chrono::minutes LeastAge{1};

/// Opens and locks a folder, or returns -1 if another open folder has the lock. The system frees it when a
/// process ends, however it ends.
int locked(const fs::path& folder) {
  const int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (file < 0) return -1;
  if (::flock(file, LOCK_EX | LOCK_NB) == 0) return file;
  ::close(file);
  return -1;
}

/// Whether a folder is of this user, and of a process that has ended.
bool is_abandoned(const fs::path& folder) {
  struct stat status = {};
  if (::lstat(folder.c_str(), &status) != 0 || !S_ISDIR(status.st_mode)) return false;
  if (status.st_uid != ::geteuid()) return false;
  std::error_code error;
  const auto changed = fs::last_write_time(folder, error);
  if (error || fs::file_time_type::clock::now() - changed < LeastAge) return false;
  const int file = locked(folder);
  if (file < 0) return false;
  ::close(file);
  return true;
}

void remove_abandoned(const fs::path& parent, const std::string& beginning) {
  std::error_code error;
  fs::directory_iterator entry(parent, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    std::error_code ignored;
    if (entry->path().filename().string().starts_with(beginning) && is_abandoned(entry->path()))
      fs::remove_all(entry->path(), ignored);
  }
}

}  // namespace

ShortLivedFolder::ShortLivedFolder(std::string_view prefix) {
  const std::string beginning = std::string(prefix) + "_";
  const fs::path parent = fs::temp_directory_path();
  remove_abandoned(parent, beginning);
  std::string name = (parent / beginning).string() + "XXXXXX";
  if (::mkdtemp(name.data()) == nullptr) throw std::system_error(errno, std::generic_category(), name);
  path_ = name;
  lock_ = locked(path_);
}

ShortLivedFolder::~ShortLivedFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
  if (lock_ >= 0) ::close(lock_);
}

}  // namespace grf
