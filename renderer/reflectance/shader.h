// BRDFs as GLSL, for pictures that a graphics processor makes. The formulas are the same text that C++ runs.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "renderer/reflectance/brdf.h"

namespace reflectance {

/// GLSL 3.30 without `#version`, for a shader of any stage.
struct Shader {
  /// Defines `vec3 brdf_value(vec3 u, vec3 v)`: f in 1/sr without the Dirac part, which is a function of one
  /// cosine and better brought as a table of `mirror`. It is the same text for all parameters of a model.
  std::string text;
  /// What the text's `uniform vec3 brdf_parameters[]` has to hold.
  std::vector<Rgb> parameters;
};

/// The shader of a BRDF, or nothing for measurements, which are no formula, and for sums that have any or
/// have more terms than a shader takes.
std::optional<Shader> shader_of(const Brdf& brdf);

/// What the formulas of these models share, and the formulas.
std::string shader_functions(const std::vector<std::string_view>& keywords);

/// The text of the k-th parameter's value, a vec3.
using ParameterText = std::function<std::string(std::size_t)>;

/// The GLSL of one model, for drawings that read the parameters of many BRDFs from a table.
struct FormulaShader {
  std::string_view keyword;
  std::string functions;  ///< they come first
  std::string call;       ///< the value for directions `u` and `v`, a vec3
};

/// The shader of the model that stands at this index in `FormulaBrdf`.
FormulaShader formula_shader(std::size_t formula, const ParameterText& parameter);

namespace detail {

template <class Model>
std::string argument(const std::string& value, float Model::*) {
  return value + ".x";
}
template <class Model>
std::string argument(const std::string& value, Rgb Model::*) {
  return value;
}
template <class Model>
std::string argument(const std::string& value, int Model::*) {
  return "int(" + value + ".x)";
}
template <class Model>
std::string argument(const std::string& value, bool Model::*) {
  return "(" + value + ".x != 0)";
}

template <class Value>
Rgb shader_value(const Value& value) {
  if constexpr (std::is_same_v<Value, Rgb>) {
    return value;
  } else {
    return Rgb(static_cast<float>(value));
  }
}

}  // namespace detail

/// The call of a model's GLSL function for `u` and `v`: its arguments are its parameters in the order of its
/// table.
template <class Model>
std::string shader_call(const ParameterText& parameter) {
  const auto table = Model::table();
  std::string call = std::string(table.keyword) + "(u, v";
  for (std::size_t k = 0; k < table.parameters.size(); ++k) {
    call += ", " + std::visit([&](auto field) { return detail::argument(parameter(k), field); },
                              table.parameters[k].field);
  }
  return call + ")";
}

/// The values of a model's parameters in the order of its table: booleans are 0 or 1, words their index.
template <class Model>
std::vector<Rgb> shader_values(const Model& model) {
  std::vector<Rgb> values;
  for (const auto& parameter : Model::table().parameters) {
    visit_field(parameter, [&](auto field) { values.push_back(detail::shader_value(model.*field)); });
  }
  return values;
}

/// A BRDF that is a formula has the same values; there are none for others.
std::vector<Rgb> shader_values(const Brdf& brdf);

/// The BRDF whose shader has these values: of the model that stands at this index in `FormulaBrdf`.
Brdf brdf_of_values(std::size_t formula, std::span<const Rgb> values);

}  // namespace reflectance
