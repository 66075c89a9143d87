#include "renderer/reflectance/shader.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <set>

#include <fmt/format.h>

#include "renderer/reflectance/each_type.h"
#include "renderer/reflectance/glsl_texts.h"

namespace reflectance {
namespace {

/// OpenGL 3.3 guarantees 1024 uniform components, some of which other uniforms need.
constexpr std::size_t MostParameters = 224;

/// The files shared by formulas, in order of dependency.
constexpr std::array SharedFiles = {"glsl_functions", "float_functions", "common",    "fresnel",
                                    "beckmann",       "refraction",      "kirchhoff", "microfacets",
                                    "facet_fresnel",  "film_fresnel",    "fibres",    "rough_diffuse",
                                    "layering",       "transmission"};

constexpr std::string_view TransmissionText = R"(
vec3 transmission(float c, int first) {
  int row = transmission_row(c);
  return mix(brdf_parameters[first + row], brdf_parameters[first + row + 1], transmission_fraction(c, row));
}
)";

std::string parameter_text(std::size_t k) { return fmt::format("brdf_parameters[{}]", k); }

/// Builds the text of a model or of the terms of a sum.
class Maker {
 public:
  bool add(const Brdf& brdf) {
    if (const auto* sum = std::get_if<Combine>(&brdf)) return add(*sum);
    return std::visit([&](const auto& model) { return add_term(model, ""); }, brdf);
  }

  Shader shader() && {
    parameters_.resize(std::max<std::size_t>(parameters_.size(), 1));
    std::string text = shader_functions({keywords_.begin(), keywords_.end()});
    text += fmt::format("uniform vec3 brdf_parameters[{}];\n", parameters_.size());
    text += TransmissionText;
    text +=
        fmt::format("vec3 brdf_value(vec3 u, vec3 v) {{ return {}; }}\n", sum_.empty() ? "vec3(0)" : sum_);
    return {std::move(text), std::move(parameters_)};
  }

 private:
  bool add(const Combine& sum) {
    if (!sum.parts) return true;
    return std::all_of(sum.parts->begin(), sum.parts->end(), [this](const CombinedBrdf& part) {
      parameters_.emplace_back(part.weight);
      std::string weight = parameter_text(parameters_.size() - 1) + ".x * ";
      if (part.transmission) weight += transmission_call(*part.transmission) + " * ";
      return std::visit([&](const auto& model) { return add_term(model, weight); }, part.brdf);
    });
  }

  /// Adds the values of what layers transmit, and returns the GLSL of the factor.
  std::string transmission_call(const Transmission& transmission) {
    const std::size_t first = parameters_.size();
    for (const Rgb& row : transmission.table()) parameters_.push_back(row);
    return fmt::format("transmission(u.z, {0}) * transmission(v.z, {0})", first);
  }

  template <class Model>
  bool add_term(const Model& model, const std::string& weight) {
    if constexpr (std::is_same_v<Model, Combine> || ReadsDataFile<Model>) {
      return false;
    } else {
      const std::size_t first = parameters_.size();
      keywords_.insert(Model::table().keyword);
      if (!sum_.empty()) sum_ += " + ";
      sum_ += weight + shader_call<Model>([first](std::size_t k) { return parameter_text(first + k); });
      for (const Rgb& value : shader_values(model)) parameters_.push_back(value);
      return parameters_.size() <= MostParameters;
    }
  }

  std::set<std::string_view> keywords_;
  std::string sum_;
  std::vector<Rgb> parameters_;
};

void assign_value(float& field, const Rgb& value) { field = value.x; }
void assign_value(Rgb& field, const Rgb& value) { field = value; }
void assign_value(int& field, const Rgb& value) { field = static_cast<int>(value.x); }
void assign_value(bool& field, const Rgb& value) { field = value.x != 0; }

}  // namespace

std::string_view shader_file(std::string_view name) {
  const auto& texts = glsl_texts();
  const auto found =
      std::find_if(texts.begin(), texts.end(), [name](const GlslText& one) { return one.name == name; });
  assert(found != texts.end());
  return found->text;
}

std::string shader_functions(const std::vector<std::string_view>& keywords) {
  std::string text;
  for (const std::string_view shared : SharedFiles) text += shader_file(shared);
  for (const std::string_view keyword : keywords) text += shader_file(keyword);
  return text;
}

std::optional<Shader> shader_of(const Brdf& brdf) {
  Maker maker;
  if (!maker.add(brdf)) return std::nullopt;
  return std::move(maker).shader();
}

FormulaShader formula_shader(std::size_t formula, const ParameterText& parameter) {
  FormulaShader shader;
  EachType<FormulaBrdf>::any([&](auto candidate) {
    if (FormulaBrdf(candidate).index() != formula) return false;
    using Model = decltype(candidate);
    const std::string_view keyword = Model::table().keyword;
    shader = {keyword, shader_functions({keyword}), shader_call<Model>(parameter)};
    return true;
  });
  return shader;
}

std::vector<Rgb> shader_values(const Brdf& brdf) {
  return std::visit(
      []<class Model>(const Model& model) {
        if constexpr (std::is_same_v<Model, Combine> || ReadsDataFile<Model>) {
          return std::vector<Rgb>();
        } else {
          return shader_values<Model>(model);
        }
      },
      static_cast<const AnyBrdf&>(brdf));
}

Brdf brdf_of_values(std::size_t formula, std::span<const Rgb> values) {
  Brdf brdf;
  EachType<FormulaBrdf>::any([&](auto model) {
    if (FormulaBrdf(model).index() != formula) return false;
    std::size_t k = 0;
    for (const auto& parameter : decltype(model)::table().parameters) {
      visit_field(parameter, [&](auto field) { assign_value(model.*field, values[k]); });
      ++k;
    }
    prepare(model);
    brdf = model;
    return true;
  });
  return brdf;
}

}  // namespace reflectance
