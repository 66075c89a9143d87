#include "confinement/confinement.h"

#include <algorithm>
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <system_error>

#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "confinement/landlock.h"
#include "confinement/system_calls.h"

namespace confinement {
namespace {

namespace fs = std::filesystem;

fs::path exact_path(const fs::path& path) {
  std::error_code error;
  const fs::path absolute = fs::absolute(path, error);
  const fs::path exact = error ? fs::path() : fs::weakly_canonical(absolute, error);
  return error || exact.empty() ? path : exact;
}

/// Returns whether a folder is `inner`, or one above it.
bool holds(const fs::path& folder, const fs::path& inner) {
  return std::mismatch(folder.begin(), folder.end(), inner.begin(), inner.end()).first == folder.end();
}

bool holds_home(const fs::path& folder) {
  const char* home = std::getenv("HOME");
  return folder == folder.root_path() || (home != nullptr && *home == '/' && holds(folder, exact_path(home)));
}

bool is_for_temporary_files(const fs::path& folder) {
  std::error_code error;
  const fs::path temporary = fs::temp_directory_path(error);
  return !error && folder == exact_path(temporary);
}

std::vector<std::string> visible_files_in(const fs::path& folder) {
  std::vector<std::string> files;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
       entry.increment(error)) {
    const bool is_hidden = entry->path().filename().string().starts_with('.');
    std::error_code unknown;
    if (!is_hidden && !entry->is_symlink(unknown) && entry->is_regular_file(unknown))
      files.push_back(entry->path().string());
  }
  return files;
}

/// Returns the folders of a file. A name in a file behind a symbolic link may be meant from either.
std::vector<fs::path> folders_of(const std::string& file) {
  std::error_code error;
  const fs::path named = fs::absolute(file, error);
  std::vector<fs::path> folders = {exact_path(named.parent_path())};
  const fs::path of_target = exact_path(named).parent_path();
  if (of_target != folders.front()) folders.push_back(of_target);
  return folders;
}

}  // namespace

Strength confine(const Policy& policy) {
  std::fflush(nullptr);
  // An open file needs no permission. Before Linux 5.9, inherited files stay open.
  static_cast<void>(::syscall(SYS_close_range, STDERR_FILENO + 1, UINT_MAX, 0));
  // Unprivileged processes need this for both: programs with more rights than theirs do not get them.
  if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return {};
  Strength strength;
  strength.landlock = confine_files(policy);  // first, since the filter leaves out what it calls
  strength.has_seccomp = confine_system_calls();
  return strength;
}

Strength available() { return {landlock_version(), has_system_call_filters()}; }

std::string description(const Strength& strength) {
  const std::string files = strength.landlock > 0
                                ? "files confined by Landlock " + std::to_string(strength.landlock)
                                : "files not confined, since this kernel has no Landlock";
  return files + (strength.has_seccomp
                      ? "; network and processes confined by seccomp"
                      : "; network and processes not confined, since this kernel has no seccomp");
}

std::vector<std::string> paths_beside(const std::string& file) {
  std::vector<std::string> paths = {file};
  for (const fs::path& folder : folders_of(file)) {
    const auto more = holds_home(folder) ? visible_files_in(folder) : std::vector{folder.string()};
    paths.insert(paths.end(), more.begin(), more.end());
  }
  return paths;
}

std::vector<std::string> paths_around(const std::string& file) {
  std::vector<std::string> paths = paths_beside(file);
  for (const fs::path& folder : folders_of(file)) {
    const fs::path above = folder.parent_path();
    if (!holds_home(above) && !is_for_temporary_files(above)) paths.push_back(above.string());
  }
  return paths;
}

}  // namespace confinement
