#include "grf/wording.h"

#include <fmt/format.h>

namespace grf {

std::string counted(std::size_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string bytes_text(std::size_t bytes) {
  if (bytes < 1000) return counted(bytes, "byte", "bytes");
  const auto size = static_cast<double>(bytes);
  return bytes < 1'000'000 ? fmt::format("{:.3g} KB", size / 1e3) : fmt::format("{:.3g} MB", size / 1e6);
}

}  // namespace grf
