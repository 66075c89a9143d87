// Every BRDF model consists of the parts below. A model is a pair of files: `ward.glsl` has its formula,
// written once for GLSL and C++, and `ward.h` a struct like this:
//
//   struct Ward {
//     float sx = 0.2F;                      // parameters with their defaults
//     static ModelTable<Ward> table();      // parameter names and ranges, and the model's description
//     template <class Real> Vec3<Real> evaluate(u, v) const;
//     Rgb specular_weight(u) const;         // only if there is a delta (ideal specular) part
//     void prepare();                       // only if something is worth computing once from the parameters
//     std::string validate() const;         // only if the ranges do not suffice to validate the values
//     float albedo_estimate(u) const;       // mean albedo without the delta part, for choosing lobes
//     std::optional<DirectionSample> sample(u, xi) const;   // importance sampling in closed form
//     float pdf(u, v) const;
//     using Data = ...;                     // only if an instance names a file; see ReadsDataFile
//     DataState data_state(u, v) const;     // likewise, if the file can lack values
//     bool is_anisotropic() const;          // and the other queries of brdf.h whose default is wrong
//   };
//
// All models and sampling schemes keep this contract. Directions are in the local frame, z = normal; u points
// towards the eye, v towards the light, both unit vectors that point away from the surface. `evaluate`
// returns f in 1/sr, RGB, finite and >= 0, without the cosine and the delta part; 0 if a direction is at or
// below the horizon. `specular_weight(u)` returns the weight w of the delta part w delta(v -
// r_u)/cos(theta_v). `pdf` is the solid-angle pdf of exactly what `sample` draws. An empty sample contributes
// nothing.
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

/// Three independent uniform numbers in [0,1): one to choose a lobe, two for a direction.
struct Uniforms {
  Vec2f direction;
  float choice = 0;
};

/// Rescales the choice to [0,1) once it fell above `taken`, so that it can be used again.
inline Uniforms rescale(Uniforms xi, float taken) {
  xi.choice = (xi.choice - taken) / (1 - taken);
  return xi;
}

/// A direction that a sampler drew, and its weight in an estimate.
struct DirectionSample {
  Vec3f direction;
  Rgb weight;  ///< f cos(theta_v) / pdf
  float pdf = 0;
};

/// A BRDF value f in 1/sr, without the delta part, and the pdf with which a sampler draws that direction.
struct Reflection {
  Rgb value;
  float pdf = 0;
};

/// The exponents of a lobe (n.h)^e about the half vector h, along the tangent and across it.
struct LobeExponents {
  float x = 0;
  float y = 0;

  /// Returns the exponents of a half-vector lobe about as wide as (v.r)^n, r the mirror direction: h turns by
  /// half as much as v, so four times the exponent does.
  static LobeExponents about_mirror(float n) { return {4 * n, 4 * n}; }
  float about_mirror() const { return (x + y) / 8; }
};

/// A model of measured data: its member `data` points to what `load` makes of the file that an instance
/// names.
template <class Model>
concept ReadsDataFile = requires {
  typename Model::Data;
};

/// The state of a BRDF's data tells whether they have a value for a pair of directions above the horizon.
enum class DataState {
  Sound,
  Missing,  ///< the file has no value there, or one that is negative or not finite
  Negative  ///< a channel is negative, and is taken as 0
};

/// One row of a model's parameter table: the field, and its description without the default, which is the
/// field's.
template <class Model>
struct Parameter {
  std::variant<float Model::*, Rgb Model::*, bool Model::*, int Model::*> field;
  grf::ParameterInfo info;
};

/// The descriptor table of a model; see grf::ModelInfo for the fields.
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
  grf::ModelInfo::ArgumentKind argument_kind = grf::ModelInfo::ArgumentKind::Parameters;
  std::string_view description = {};
  std::string_view formula = {};  ///< an empty first line is skipped
  std::string_view example = {};
};

/// Fills in the kind and the default of a parameter's description by its field.
inline void describe(grf::ParameterInfo& entry, float default_value) {
  entry.kind = grf::ParameterKind::Number;
  entry.default_value = default_value;
}
/// Describes a colour likewise.
inline void describe(grf::ParameterInfo& entry, const Rgb& default_value) {
  entry.kind = grf::ParameterKind::Reflectance;
  entry.default_value = default_value.x;
  if (default_value != Rgb(default_value.x)) entry.default_rgb = default_value;
}
/// Describes a boolean likewise: the default is 0 or 1.
inline void describe(grf::ParameterInfo& entry, bool default_value) {
  entry.kind = grf::ParameterKind::Boolean;
  entry.default_value = default_value ? 1.0F : 0.0F;
}

/// Describes a parameter that takes words: the default is an index.
inline void describe(grf::ParameterInfo& entry, int default_choice) {
  entry.kind = grf::ParameterKind::Word;
  entry.default_value = static_cast<float>(default_choice);
}

/// Sets a field to a value of a scene, which was checked.
inline void assign(float& field, const grf::Value& value, const grf::ParameterInfo&) {
  if (const auto* number = std::get_if<float>(&value)) field = *number;
}
/// Sets a colour likewise; a number is grey.
inline void assign(Rgb& field, const grf::Value& value, const grf::ParameterInfo&) {
  if (const auto* number = std::get_if<float>(&value)) field = Rgb(*number);
  if (const auto* rgb = std::get_if<grf::Colour>(&value)) field = *rgb;
}
/// Sets a boolean likewise; a number other than 0 is true.
inline void assign(bool& field, const grf::Value& value, const grf::ParameterInfo&) {
  if (const auto* flag = std::get_if<bool>(&value)) field = *flag;
  if (const auto* number = std::get_if<float>(&value)) field = *number != 0;
}

/// Sets a field to the index of a word.
inline void assign(int& field, const grf::Value& value, const grf::ParameterInfo& parameter) {
  const auto* word = std::get_if<grf::Word>(&value);
  if (word == nullptr) return;
  for (std::size_t i = 0; i < parameter.choices.size(); ++i) {
    if (grf::same_keyword(word->text, parameter.choices[i])) field = static_cast<int>(i);
  }
}

/// Calls visit(field) for the field of a row. Skips field types larger than the model, since g++ 12 warns of
/// an access that never happens.
template <class Model, class Visit>
void visit_field(const Parameter<Model>& parameter, Visit visit) {
  std::visit(
      [&]<class Field>(Field Model::*field) {
        if constexpr (sizeof(Field) <= sizeof(Model)) visit(field);
      },
      parameter.field);
}

/// Lets a model compute what depends on its parameters alone. Whoever sets them calls this.
template <class Model>
void prepare(Model& model) {
  if constexpr (requires { model.prepare(); }) model.prepare();
}

/// Returns the argument that gives a parameter's value, its own or that of the parameter whose value is its
/// default; null if there is none.
template <class Model>
const grf::Argument* argument_for(const Parameter<Model>& parameter, const ModelTable<Model>& table,
                                  const grf::Model& data) {
  const grf::Argument* own = grf::find_argument(data, parameter.info);
  if (own != nullptr || parameter.info.default_from.empty()) return own;
  for (const Parameter<Model>& other : table.parameters) {
    if (other.info.is_called(parameter.info.default_from)) return grf::find_argument(data, other.info);
  }
  return nullptr;
}

/// Makes a model from data that `grf::check` found valid: omitted values take their defaults.
template <class Model>
Model make(const grf::Model& data) {
  Model model;
  const ModelTable<Model> table = Model::table();
  for (const Parameter<Model>& parameter : table.parameters) {
    const grf::Argument* argument = argument_for(parameter, table, data);
    if (argument == nullptr) continue;
    visit_field(parameter, [&](auto field) { assign(model.*field, argument->value, parameter.info); });
  }
  prepare(model);
  return model;
}

/// Returns the type-erased descriptor of a model.
template <class Model>
grf::ModelInfo info_of() {
  const ModelTable<Model> table = Model::table();
  grf::ModelInfo info;
  info.keyword = table.keyword;
  info.title = table.title;
  info.paper = table.paper;
  info.description = table.description;
  info.formula = table.formula.substr(table.formula.starts_with('\n') ? 1 : 0);
  info.example = table.example;
  info.not_isotropic = table.not_isotropic;
  info.not_reciprocal = table.not_reciprocal;
  info.not_conserving = table.not_conserving;
  info.not_continuous = table.not_continuous;
  info.argument_kind = table.argument_kind;
  static const Model defaults;
  for (const Parameter<Model>& parameter : table.parameters) {
    info.parameters.push_back(parameter.info);
    grf::ParameterInfo& entry = info.parameters.back();
    visit_field(parameter, [&](auto field) { describe(entry, defaults.*field); });
  }
  if constexpr (requires { defaults.validate(); }) {
    info.validate = [](const grf::Model& data) { return make<Model>(data).validate(); };
  }
  return info;
}

// The functions below make rows of parameter tables.

/// Makes the row of a colour from 0 to 1.
template <class Model>
Parameter<Model> reflectance_parameter(Rgb Model::*field, std::string_view name, std::string_view help,
                                       std::vector<std::string_view> aliases = {}) {
  grf::ParameterInfo info;
  info.name = name;
  info.aliases = std::move(aliases);
  info.help = help;
  return {field, std::move(info)};
}

/// Makes the row of a number that may differ per channel, such as a wavelength.
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

/// Makes the row of a boolean.
template <class Model>
Parameter<Model> boolean_parameter(bool Model::*field, std::string_view name, std::string_view help) {
  grf::ParameterInfo info;
  info.name = name;
  info.help = help;
  return {field, std::move(info)};
}

/// Makes the row of an enumeration of keywords; the field is the keyword's index.
template <class Model>
Parameter<Model> word_parameter(int Model::*field, std::string_view name,
                                std::vector<std::string_view> choices, std::string_view help) {
  grf::ParameterInfo info;
  info.name = name;
  info.choices = std::move(choices);
  info.help = help;
  return {field, std::move(info)};
}

/// Makes the row of a number from a minimum to a maximum.
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

/// Returns the row of a number that is to be whole, such as a count.
template <class Model>
Parameter<Model> whole(Parameter<Model> parameter) {
  parameter.info.is_whole = true;
  return parameter;
}

/// Returns the row with a unit added.
template <class Model>
Parameter<Model> in_unit(std::string_view unit, Parameter<Model> parameter) {
  parameter.info.unit = unit;
  return parameter;
}

}  // namespace reflectance
