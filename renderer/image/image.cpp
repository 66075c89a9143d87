#include "renderer/image/image.h"

#include <filesystem>

#include "grf/keywords.h"

namespace image {

bool has_extension(const std::string& path, std::string_view extension) {
  const std::string ending = std::filesystem::path(path).extension().string();
  return !ending.empty() && grf::same_keyword(ending.substr(1), extension);
}

}  // namespace image
