#pragma once

#include <filesystem>
#include <string_view>

namespace grf {

/// A new folder in the system's folder for temporary files, removed with all that is in it by the destructor.
class ShortLivedFolder {
 public:
  /// The folder's name begins with this prefix. Throws std::system_error if it cannot be made.
  explicit ShortLivedFolder(std::string_view prefix);
  ~ShortLivedFolder();
  ShortLivedFolder(const ShortLivedFolder&) = delete;
  ShortLivedFolder& operator=(const ShortLivedFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace grf
