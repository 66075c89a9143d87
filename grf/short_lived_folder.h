#pragma once

#include <filesystem>
#include <string_view>

namespace grf {

/// A new folder in the system's folder for temporary files, removed with all that is in it by the destructor.
/// A folder that a killed process left is removed when any process makes one of the same prefix a minute or
/// more later.
class ShortLivedFolder {
 public:
  /// The folder's name begins with this prefix. Throws std::system_error if it cannot be made.
  explicit ShortLivedFolder(std::string_view prefix);
  ~ShortLivedFolder();
  ShortLivedFolder(const ShortLivedFolder&) = delete;
  ShortLivedFolder& operator=(const ShortLivedFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }  ///< Returns the folder's path.

 private:
  std::filesystem::path path_;
  int lock_ = -1;  ///< the opened folder, locked while it is in use; -1 where that is not possible
};

}  // namespace grf
