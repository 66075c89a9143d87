#include "grf/short_lived_folder.h"

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>

namespace grf {

ShortLivedFolder::ShortLivedFolder(std::string_view prefix) {
  std::string name = (std::filesystem::temp_directory_path() / prefix).string() + "_XXXXXX";
  if (::mkdtemp(name.data()) == nullptr) throw std::system_error(errno, std::generic_category(), name);
  path_ = name;
}

ShortLivedFolder::~ShortLivedFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace grf
