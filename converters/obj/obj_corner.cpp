#include "converters/obj/obj_corner.h"

#include <charconv>
#include <cstddef>
#include <system_error>

#include "converters/index_table.h"

namespace convert {
namespace {

/// Parses an index at the front of the text: digits that do not begin with 0, with an optional minus sign.
bool take_index(std::string_view& text, long long& index) {
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, index);
  const bool has_leading_zero = text.substr(text.starts_with('-') ? 1 : 0).starts_with('0');
  if (result.ec != std::errc() || has_leading_zero) return false;
  text.remove_prefix(static_cast<std::size_t>(result.ptr - text.data()));
  return true;
}

}  // namespace

std::optional<WrittenCorner> parse_corner(std::string_view word) {
  WrittenCorner corner;
  if (!take_index(word, corner.vertex)) return std::nullopt;
  for (long long* part : {&corner.texture_coordinate, &corner.normal}) {
    if (!word.starts_with('/')) break;
    word.remove_prefix(1);
    if (!word.empty() && word.front() != '/' && !take_index(word, *part)) return std::nullopt;
  }
  return word.empty() ? std::optional(corner) : std::nullopt;
}

std::uint64_t hash_of(const ObjCorner& corner) {
  const std::uint64_t others = static_cast<std::uint64_t>(corner.texture_coordinate) << 32U | corner.normal;
  return mixed_hash(mixed_hash(0, corner.vertex), others);
}

}  // namespace convert
