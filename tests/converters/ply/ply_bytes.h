#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <string>
#include <string_view>

#include <fmt/format.h>

namespace convert {

/// A writer of the bytes of a PLY file in one of the three encodings, value by value.
class PlyBytes {
 public:
  /// `ascii`, `binary_little_endian` or `binary_big_endian`.
  explicit PlyBytes(std::string_view encoding)
      : bytes_(fmt::format("ply\nformat {} 1.0\n", encoding)),
        is_text_(encoding == "ascii"),
        swaps_((encoding == "binary_big_endian") != (std::endian::native == std::endian::big)) {}

  PlyBytes& line(std::string_view text) {
    bytes_.append(text).append("\n");
    return *this;
  }

  template <class T>
  PlyBytes& put(T value) {
    if (is_text_) {
      bytes_ += fmt::format("{} ", +value);
      return *this;
    }
    auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
    if (swaps_) std::reverse(bytes.begin(), bytes.end());
    bytes_.append(bytes.data(), bytes.size());
    return *this;
  }

  /// Ends a line in text.
  PlyBytes& end() {
    if (is_text_) bytes_.back() = '\n';
    return *this;
  }

  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
  bool is_text_;
  bool swaps_;
};

}  // namespace convert
