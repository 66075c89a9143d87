#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace convert {

/// A corner as written in a face: indices count from 1, or, if negative, back from the last element; 0 means
/// omitted.
struct WrittenCorner {
  long long vertex = 0;
  long long texture_coordinate = 0;
  long long normal = 0;
};

/// Parses a corner `v`, `v/t`, `v//n` or `v/t/n`; the fields after the vertex may be empty.
std::optional<WrittenCorner> parse_corner(std::string_view word);

/// A corner with resolved indices, from 0; texture coordinates and normal may be missing.
struct ObjCorner {
  static constexpr std::uint32_t InvalidIndex = 0xFFFFFFFF;

  std::uint32_t vertex = InvalidIndex;
  std::uint32_t texture_coordinate = InvalidIndex;
  std::uint32_t normal = InvalidIndex;

  bool operator==(const ObjCorner&) const = default;
};

std::uint64_t hash_of(const ObjCorner& corner);

}  // namespace convert
