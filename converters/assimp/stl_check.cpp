#include "converters/assimp/stl_check.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include <fmt/format.h>

#include "converters/text_encoding.h"
#include "converters/wording.h"

namespace convert {
namespace {

constexpr std::size_t HeaderSize = 80;
constexpr std::size_t CountSize = 4;
constexpr std::size_t FacetSize = 50;

std::uint64_t facets_announced(std::string_view bytes) {
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < CountSize; ++i) {
    count |= std::uint64_t{static_cast<std::uint8_t>(bytes[HeaderSize + i])} << (8 * i);
  }
  return count;
}

}  // namespace

bool is_text_stl(std::string_view first_bytes) {
  const std::size_t begin = std::min(first_bytes.find_first_not_of(" \t\r\n"), first_bytes.size());
  const std::string_view text = first_bytes.substr(begin);
  if (!text.starts_with("solid") || text.find('\0') != std::string_view::npos) return false;
  // The header of a binary file may begin with that word too.
  return text.find("facet") != std::string_view::npos || text.find("endsolid") != std::string_view::npos;
}

std::optional<std::string_view> check_stl(std::string_view bytes, const grf::SourceLocation& location,
                                          grf::Diagnostics& diagnostics) {
  const bool has_count = bytes.size() >= HeaderSize + CountSize;
  const std::uint64_t facets = has_count ? facets_announced(bytes) : 0;
  const std::uint64_t size = HeaderSize + CountSize + FacetSize * facets;
  if (has_count && size == bytes.size()) return bytes;
  if (is_text_stl(bytes)) return bytes;
  if (!has_count) {
    diagnostics.error(location,
                      "the file is not an STL model: it has neither facets in text nor the 84 bytes "
                      "that a binary file begins with");
    return {};
  }
  if (size > bytes.size()) {
    const std::size_t there = (bytes.size() - HeaderSize - CountSize) / FacetSize;
    diagnostics.error(location,
                      fmt::format("the file ends after {} of {}", there, counted(facets, "facet", "facets")));
    return {};
  }
  const std::string_view rest = bytes.substr(size);
  if (is_padding(rest)) return bytes.substr(0, size);
  diagnostics.error(location, fmt::format("{} the last of {}: the count is wrong, or the file was damaged",
                                          counted(rest.size(), "byte follows", "bytes follow"),
                                          counted(facets, "facet", "facets")));
  return {};
}

}  // namespace convert
