#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "grf/keywords.h"
#include "renderer/reflectance/model.h"

namespace reflectance {

/// Calls a function with a default-constructed value of each type of a variant, until one call returns true.
template <class Variant>
struct EachType;

template <class... Types>
struct EachType<std::variant<Types...>> {
  template <class Function>
  static bool any(Function function) {
    return (function(Types()) || ...);
  }
};

/// Makes a Class that holds the variant's type with that keyword and the model's values, or returns nothing
/// if no type has the keyword.
template <class Class, class Variant>
std::optional<Class> make_any(const grf::Model& data) {
  std::optional<Class> made;
  EachType<Variant>::any([&](auto candidate) {
    using Candidate = decltype(candidate);
    if (!grf::same_keyword(Candidate::table().keyword, data.keyword)) return false;
    made = make<Candidate>(data);
    return true;
  });
  return made;
}

/// Returns the descriptors of all types of the variant.
template <class Variant>
std::vector<grf::ModelInfo> infos_of() {
  std::vector<grf::ModelInfo> infos;
  EachType<Variant>::any([&](auto candidate) {
    infos.push_back(info_of<decltype(candidate)>());
    return false;
  });
  return infos;
}

}  // namespace reflectance
