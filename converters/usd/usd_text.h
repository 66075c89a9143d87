// The text of USD files (usda), an element at a time.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "grf/math.h"
#include "grf/write.h"

namespace convert {

/// Returns a string of USD in quotes; UTF-8.
std::string usd_string(std::string_view text);
/// Returns an asset path between marks. A relative one begins at the folder of the file that names it.
std::string usd_asset(std::string_view path);
/// Returns a number with the fewest digits that give the same float.
std::string usd_number(float value);
std::string usd_number(double value);

template <class Number>
std::string usd_tuple(const Imath::Vec3<Number>& v) {
  return fmt::format("({}, {}, {})", usd_number(v.x), usd_number(v.y), usd_number(v.z));
}
template <class Number>
std::string usd_tuple(const Imath::Vec2<Number>& v) {
  return fmt::format("({}, {})", usd_number(v.x), usd_number(v.y));
}
/// Returns a matrix for row vectors, as GRF and USD have them.
std::string usd_matrix(const grf::Matrix44d& matrix);

/// Returns the metadata of a prim that keep what only GRF has: a dictionary `grf` of declarations.
std::vector<std::string> usd_custom_data(std::span<const std::string> declarations);

/// Composes indented text.
class UsdText {
 public:
  void line(std::string_view text);
  /// Begins a prim: `def Mesh "name"`, with lines of metadata in parentheses.
  void begin(std::string_view header, std::span<const std::string> metadata = {});
  void end();
  /// Puts an array, `int[] name = [...]`, of elements that a function writes.
  template <class Element>
  void array(std::string_view declaration, std::size_t size, const Element& element,
             std::string_view metadata = {}) {
    std::string whole = fmt::format("{} = [", declaration);
    for (std::size_t i = 0; i < size; ++i) {
      if (i > 0) whole += ", ";
      whole += element(i);
    }
    line(whole + ']' + std::string(metadata));
  }

  std::string text;

 private:
  std::size_t depth_ = 0;
};

}  // namespace convert
