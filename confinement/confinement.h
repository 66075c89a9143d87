// Confinement of processes that read untrusted files: a file that exploits a reader is left with little to
// do.
#pragma once

#include <string>
#include <vector>

namespace confinement {

/// What a process may use from now on.
struct Policy {
  /// Files to read, and folders to read with all that is in them. Missing ones are ignored.
  std::vector<std::string> readable;
  /// Folders in which, and below which, files and folders may be created, replaced and removed. They are not
  /// readable unless they are listed above, too.
  std::vector<std::string> writable;
};

/// What confines a process. Both are properties of the kernel, which may lack them.
struct Strength {
  /// Files are confined by this version of Landlock's interface (Linux 5.13 and later); 0: they are not.
  int landlock = 0;
  /// System calls are confined by seccomp: there is no network, no other program and no other process.
  bool has_seccomp = false;
};

/// Confines this process, and all threads that it starts, for as long as it lives. What the policy does not
/// list fails as without permission (EACCES or EPERM). The files of installed libraries stay readable, and
/// open standard streams stay usable; other inherited files are closed.
///
/// Call it before the first thread starts: Landlock confines only the calling one. A confinement that the
/// kernel lacks is left out.
Strength confine(const Policy& policy);

/// Returns what `confine` would do, without doing it.
Strength available();

/// Returns a sentence about it for users.
std::string description(const Strength& strength);

/// Returns the paths of a file and its folder. Of the home folder, and of folders above it, it returns only
/// the visible files directly in them, since the rest has nothing to do with the file.
std::vector<std::string> paths_beside(const std::string& file);

/// Returns what a model or scene may name: the paths beside it, and the folder above, for names such as
/// `../textures/wood.png`, unless that is the home folder, one above it or the folder for temporary files.
std::vector<std::string> paths_around(const std::string& file);

}  // namespace confinement
