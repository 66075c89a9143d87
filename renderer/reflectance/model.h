// What every BRDF model is made of. A model is a pair of files: `ward.glsl` has its formula, written once for
// GLSL and C++, and `ward.h` a struct like this:
//
//   struct Ward {
//     float sx = 0.2F;                        // parameters, with their defaults
//     static ModelTable<Ward> table();        // names, ranges, and in words what the model is
//     template <class Real> Vec3<Real> evaluate(u, v) const;
//     Rgb mirror(u) const;                    // only where there is a Dirac part
//     std::string wrong_together() const;     // only where ranges alone do not say which values are right
//     float albedo_estimate(u) const;         // mean reflectance without the Dirac part, for picking parts
//     std::optional<DirectionSample> sample(u, xi) const;   // its own closed form
//     float density(u, v) const;
//     bool is_anisotropic() const;            // and the others that brdf.h names, where it guesses wrong
//   };
//
// The contract, which all models and sampling schemes keep: local frame, z = normal; u towards the eye, v
// towards the light, both unit and pointing away from the surface. `evaluate` is f in 1/sr, finite and >= 0,
// RGB, without cosine and without the Dirac part; 0 where a direction is at or under the horizon. `mirror(u)`
// is the weight w of the Dirac part w delta(v - r_u)/cos(theta_v). `density` is per solid angle, of exactly
// what `sample` draws. An empty sample is one that carries nothing.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "grf/catalogue.h"
#include "grf/keywords.h"
#include "grf/model.h"
#include "renderer/reflectance/geometry.h"

namespace reflectance {

template <class Real>
using Vec3 = Imath::Vec3<Real>;

/// Three independent uniform numbers in [0,1): one to choose a part with, two for a direction.
struct Uniforms {
  Vec2f direction;
  float choice = 0;
};

/// What is left of them when the choice fell on a part above `taken`.
inline Uniforms rest_of(Uniforms xi, float taken) {
  xi.choice = (xi.choice - taken) / (1 - taken);
  return xi;
}

struct DirectionSample {
  Vec3f direction;
  Rgb weight;  ///< f cos(theta_v) / density
  float density = 0;
};

/// f in 1/sr without the Dirac part, and the density with which a sampler draws that direction.
struct Reflection {
  Rgb value;
  float density = 0;
};

/// The exponents of a lobe (n.h)^e about the half vector h, along the tangent and across it.
struct LobeExponents {
  float x = 0;
  float y = 0;

  /// Those of about the lobe (v.r)^n, r the mirror direction: h turns by half of what v does, so a quarter
  /// of the exponent does for v.
  static LobeExponents about_mirror(float n) { return {4 * n, 4 * n}; }
  float about_mirror() const { return (x + y) / 8; }
};

/// One row of a model's table: the field, and all that is said of it but its default, which is the field's.
template <class Model>
struct Parameter {
  std::variant<float Model::*, Rgb Model::*, bool Model::*, int Model::*> field;
  grf::ParameterInfo info;
};

/// See grf::ModelInfo.
template <class Model>
struct ModelTable {
  std::string_view keyword;
  std::string_view title;
  std::string_view paper = {};
  std::vector<Parameter<Model>> parameters = {};
  std::string_view not_isotropic = {};
  std::string_view not_reciprocal = {};
  std::string_view not_conserving = {};
  std::string_view not_continuous = {};
  grf::ModelInfo::Takes takes = grf::ModelInfo::Takes::Parameters;
  std::string_view about = {};
  std::string_view formula = {};  ///< a first line that is empty does not count
  std::string_view example = {};
};

inline void describe(grf::ParameterInfo& entry, float default_value) {
  entry.kind = grf::ParameterKind::Number;
  entry.default_value = default_value;
}
inline void describe(grf::ParameterInfo& entry, const Rgb& default_value) {
  entry.kind = grf::ParameterKind::Reflectance;
  entry.default_value = default_value.x;
  if (default_value != Rgb(default_value.x)) entry.default_rgb = default_value;
}
inline void describe(grf::ParameterInfo& entry, bool default_value) {
  entry.kind = grf::ParameterKind::Boolean;
  entry.default_value = default_value ? 1.0F : 0.0F;
}

inline void describe(grf::ParameterInfo& entry, int default_choice) {
  entry.kind = grf::ParameterKind::Word;
  entry.default_value = static_cast<float>(default_choice);
}

inline void assign(float& field, const grf::Value& value, const grf::ParameterInfo&) {
  if (const auto* number = std::get_if<float>(&value)) field = *number;
}
inline void assign(Rgb& field, const grf::Value& value, const grf::ParameterInfo&) {
  if (const auto* number = std::get_if<float>(&value)) field = Rgb(*number);
  if (const auto* rgb = std::get_if<grf::Colour>(&value)) field = *rgb;
}
inline void assign(bool& field, const grf::Value& value, const grf::ParameterInfo&) {
  if (const auto* flag = std::get_if<bool>(&value)) field = *flag;
  if (const auto* number = std::get_if<float>(&value)) field = *number != 0;
}

inline void assign(int& field, const grf::Value& value, const grf::ParameterInfo& parameter) {
  const auto* word = std::get_if<grf::Word>(&value);
  if (word == nullptr) return;
  for (std::size_t i = 0; i < parameter.choices.size(); ++i) {
    if (grf::same_keyword(word->text, parameter.choices[i])) field = static_cast<int>(i);
  }
}

/// Calls visit(field) for the field of a row. What a model is too small for it has none of, and g++ 12 warns
/// of an access that is never made.
template <class Model, class Visit>
void visit_field(const Parameter<Model>& parameter, Visit visit) {
  std::visit(
      [&]<class Field>(Field Model::*field) {
        if constexpr (sizeof(Field) <= sizeof(Model)) visit(field);
      },
      parameter.field);
}

/// A model from its data, which `grf::check` found right: values that are left out take their defaults.
template <class Model>
Model make(const grf::Model& data) {
  Model model;
  const ModelTable<Model> table = Model::table();
  const auto argument_of = [&](std::string_view name) -> const grf::Argument* {
    for (const Parameter<Model>& parameter : table.parameters) {
      if (parameter.info.is_called(name)) return grf::find_argument(data, parameter.info);
    }
    return nullptr;
  };
  for (const Parameter<Model>& parameter : table.parameters) {
    const grf::Argument* argument = grf::find_argument(data, parameter.info);
    if (argument == nullptr && !parameter.info.default_from.empty()) {
      argument = argument_of(parameter.info.default_from);
    }
    if (argument == nullptr) continue;
    visit_field(parameter, [&](auto field) { assign(model.*field, argument->value, parameter.info); });
  }
  return model;
}

/// The descriptor of a model for those who do not know its type.
template <class Model>
grf::ModelInfo info_of() {
  const ModelTable<Model> table = Model::table();
  grf::ModelInfo info;
  info.keyword = table.keyword;
  info.title = table.title;
  info.paper = table.paper;
  info.about = table.about;
  info.formula = table.formula.substr(table.formula.starts_with('\n') ? 1 : 0);
  info.example = table.example;
  info.not_isotropic = table.not_isotropic;
  info.not_reciprocal = table.not_reciprocal;
  info.not_conserving = table.not_conserving;
  info.not_continuous = table.not_continuous;
  info.takes = table.takes;
  static const Model defaults;
  for (const Parameter<Model>& parameter : table.parameters) {
    info.parameters.push_back(parameter.info);
    grf::ParameterInfo& entry = info.parameters.back();
    visit_field(parameter, [&](auto field) { describe(entry, defaults.*field); });
  }
  if constexpr (requires { defaults.wrong_together(); }) {
    info.wrong_together = [](const grf::Model& data) { return make<Model>(data).wrong_together(); };
  }
  return info;
}

// Rows of tables.

template <class Model>
Parameter<Model> reflectance_parameter(Rgb Model::*field, std::string_view name, std::string_view help,
                                       std::vector<std::string_view> aliases = {}) {
  grf::ParameterInfo info;
  info.name = name;
  info.aliases = std::move(aliases);
  info.help = help;
  return {field, std::move(info)};
}

/// A number that may differ from channel to channel, such as a wavelength.
template <class Model>
Parameter<Model> rgb_parameter(Rgb Model::*field, std::string_view name, float minimum, float maximum,
                               std::string_view help, grf::ParameterScale scale = grf::ParameterScale::Linear,
                               std::vector<std::string_view> aliases = {}) {
  Parameter<Model> parameter = reflectance_parameter(field, name, help, std::move(aliases));
  parameter.info.minimum = minimum;
  parameter.info.maximum = maximum;
  parameter.info.scale = scale;
  return parameter;
}

template <class Model>
Parameter<Model> boolean_parameter(bool Model::*field, std::string_view name, std::string_view help) {
  grf::ParameterInfo info;
  info.name = name;
  info.help = help;
  return {field, std::move(info)};
}

/// One of some words; the field is its index.
template <class Model>
Parameter<Model> word_parameter(int Model::*field, std::string_view name,
                                std::vector<std::string_view> choices, std::string_view help) {
  grf::ParameterInfo info;
  info.name = name;
  info.choices = std::move(choices);
  info.help = help;
  return {field, std::move(info)};
}

template <class Model>
Parameter<Model> number_parameter(float Model::*field, std::string_view name, float minimum, float maximum,
                                  std::string_view help,
                                  grf::ParameterScale scale = grf::ParameterScale::Linear,
                                  std::vector<std::string_view> aliases = {}) {
  grf::ParameterInfo info;
  info.name = name;
  info.aliases = std::move(aliases);
  info.minimum = minimum;
  info.maximum = maximum;
  info.scale = scale;
  info.help = help;
  return {field, std::move(info)};
}

/// The same row with a unit of its values.
template <class Model>
Parameter<Model> in_unit(std::string_view unit, Parameter<Model> parameter) {
  parameter.info.unit = unit;
  return parameter;
}

}  // namespace reflectance
