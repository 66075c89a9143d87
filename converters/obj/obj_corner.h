#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace convert {

/// A corner as a face writes it: an index counts from 1, or, negative, back from the last element; it is 0
/// where it is left out.
struct WrittenCorner {
  long long vertex = 0;
  long long texture_coordinate = 0;
  long long normal = 0;
};

/// `v`, `v/t`, `v//n` or `v/t/n`; the parts behind the vertex may be left empty.
std::optional<WrittenCorner> parse_corner(std::string_view word);

/// A corner whose elements are known: indices from 0, of which the last two may be left out.
struct ObjCorner {
  static constexpr std::uint32_t None = 0xFFFFFFFF;

  std::uint32_t vertex = None;
  std::uint32_t texture_coordinate = None;
  std::uint32_t normal = None;

  bool operator==(const ObjCorner&) const = default;
};

std::uint64_t hash_of(const ObjCorner& corner);

}  // namespace convert
