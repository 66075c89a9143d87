#pragma once

#include <string>

#include <fmt/format.h>

namespace convert {

/// Returns the components of a vector or colour, separated by spaces.
template <class Vector>
std::string words(const Vector& v) {
  return fmt::format("{} {} {}", v.x, v.y, v.z);
}

}  // namespace convert
