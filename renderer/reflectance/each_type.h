#pragma once

#include <variant>

namespace reflectance {

/// Calls a function with a default of each type of a variant, until one call returns true.
template <class Variant>
struct EachType;

template <class... Types>
struct EachType<std::variant<Types...>> {
  template <class Function>
  static bool any(Function function) {
    return (function(Types()) || ...);
  }
};

}  // namespace reflectance
