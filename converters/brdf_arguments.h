#pragma once

#include <algorithm>
#include <initializer_list>
#include <string_view>
#include <variant>

#include "grf/keywords.h"
#include "grf/math.h"
#include "grf/model.h"

namespace convert {

/// The arguments of a BRDF, by name. Callers know the defaults and aliases of MODELS.md, which tests compare.
class BrdfArguments {
 public:
  explicit BrdfArguments(const grf::BrdfModel& brdf) : brdf_(brdf) {}

  /// Returns the first number among these names, or another value.
  double number(std::initializer_list<std::string_view> names, double otherwise) const {
    const grf::Value* value = find_value(names);
    const float* number = value == nullptr ? nullptr : std::get_if<float>(value);
    return number == nullptr ? otherwise : static_cast<double>(*number);
  }
  /// Returns the first colour likewise; a number is grey.
  grf::Vec3d colour(std::initializer_list<std::string_view> names, double otherwise) const {
    const grf::Value* value = find_value(names);
    const auto* colour = value == nullptr ? nullptr : std::get_if<grf::Colour>(value);
    return colour == nullptr ? grf::Vec3d(number(names, otherwise)) : grf::Vec3d(*colour);
  }
  /// Returns whether a boolean, or a number other than 0, is set.
  bool flag(std::string_view name) const {
    const grf::Value* value = find_value({name});
    const bool* flag = value == nullptr ? nullptr : std::get_if<bool>(value);
    return flag == nullptr ? number({name}, 0) != 0 : *flag;
  }
  /// Returns the image of the first one likewise, or nothing.
  std::optional<grf::ParameterMap> map(std::initializer_list<std::string_view> names) const {
    const grf::Argument* argument = find(names);
    return argument == nullptr ? std::nullopt : argument->map;
  }
  /// Fresnel's reflectance at normal incidence; an index of 0 is a perfect conductor.
  double fresnel(double default_real) const {
    const double n = number({"nreal", "ior"}, default_real);
    const double k = number({"nimag"}, 0);
    if (n == 0) return 1;
    return ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k);
  }

 private:
  const grf::Value* find_value(std::initializer_list<std::string_view> names) const {
    const grf::Argument* argument = find(names);
    return argument == nullptr ? nullptr : &argument->value;
  }
  const grf::Argument* find(std::initializer_list<std::string_view> names) const {
    for (const grf::Argument& argument : brdf_.arguments) {
      const auto is_called = [&](std::string_view name) { return grf::same_keyword(argument.name, name); };
      if (std::any_of(names.begin(), names.end(), is_called)) return &argument;
    }
    return nullptr;
  }

  const grf::BrdfModel& brdf_;
};

}  // namespace convert
