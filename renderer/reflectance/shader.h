// BRDFs are written as GLSL, for shaders on a GPU. The formulas are the same text that C++ runs.
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

/// Shader code in GLSL 3.30 without `#version`, for any stage.
struct Shader {
  /// Defines `vec3 brdf_value(vec3 u, vec3 v)`: f in 1/sr without the delta part, which depends on one cosine
  /// and is better passed as a table of `specular_weight`. The text is the same for all parameters of a
  /// model.
  std::string text;
  /// Values of the text's `uniform vec3 brdf_parameters[]`.
  std::vector<Rgb> parameters;
};

/// Returns the shader of a BRDF, or nothing for measured data and for sums that contain some or have more
/// terms than a shader supports.
std::optional<Shader> shader_of(const Brdf& brdf);

/// Returns a file of GLSL by its name, such as `common`.
std::string_view shader_file(std::string_view name);

/// Returns the formulas of these models with the functions that they share.
std::string shader_functions(const std::vector<std::string_view>& keywords);

/// Returns the GLSL expression of the k-th parameter's value, a vec3.
using ParameterText = std::function<std::string(std::size_t)>;

/// The GLSL of one model, for shaders that read the parameters of many BRDFs from a table.
struct FormulaShader {
  std::string_view keyword;
  std::string functions;  ///< definitions, to be placed first
  std::string call;       ///< expression of the value for directions `u` and `v`, a vec3
};

/// Returns the shader of the model at this index in `FormulaBrdf`.
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

/// Returns the call of a model's GLSL function for `u` and `v`, with its parameters as arguments in table
/// order.
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

/// Returns the values of a model's parameters in table order: booleans are 0 or 1, keywords their index.
template <class Model>
std::vector<Rgb> shader_values(const Model& model) {
  std::vector<Rgb> values;
  for (const auto& parameter : Model::table().parameters) {
    visit_field(parameter, [&](auto field) { values.push_back(detail::shader_value(model.*field)); });
  }
  return values;
}

/// Returns the parameter values of an analytic BRDF; empty for others.
std::vector<Rgb> shader_values(const Brdf& brdf);

/// Makes the BRDF with these shader values, of the model at this index in `FormulaBrdf`.
Brdf brdf_of_values(std::size_t formula, std::span<const Rgb> values);

}  // namespace reflectance
