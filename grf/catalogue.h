// The catalogue describes BRDF models and sampling schemes in tables that the reflectance library fills, and
// validates models against them. The tables drive command lines, documents and the editor's forms too.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grf/diagnostics.h"
#include "grf/model.h"

namespace grf {

/// The kind of values that a parameter takes.
enum class ParameterKind {
  Number,
  Reflectance,  ///< a number, or an RGB triple of numbers in the same range
  Boolean,
  Word,  ///< one of `choices`
};

/// The scale of a slider for the parameter.
enum class ParameterScale { Linear, Logarithmic };

/// Describes a parameter of a model: its name, range, default, unit and meaning.
struct ParameterInfo {
  std::string_view name;
  std::vector<std::string_view> aliases;
  ParameterKind kind = ParameterKind::Number;
  float minimum = 0;
  float maximum = 1;
  float default_value = 0;
  bool is_whole = false;              ///< of a number: only whole numbers are valid
  std::optional<Colour> default_rgb;  ///< the default if its channels differ; default_value is the first one
  std::vector<std::string_view> choices;  ///< the words allowed; default_value is the index of the default
  std::string_view default_from;          ///< the parameter whose value is the default; empty: default_value
  ParameterScale scale = ParameterScale::Linear;
  std::string_view unit;
  std::string_view help;

  bool is_called(std::string_view word) const;  ///< by name or alias
};

/// The maximum of a BRDF's directional albedo, and the angle of incidence at which it occurs.
struct LargestAlbedo {
  float albedo = 0;   ///< reflected / incident flux
  float degrees = 0;  ///< from the normal
};

/// Describes a BRDF model or a sampling scheme.
struct ModelInfo {
  /// The kind of argument that the keyword takes besides parameters.
  enum class ArgumentKind {
    Parameters,
    Terms,     ///< weights and names of defined BRDFs
    Layers,    ///< names of defined BRDFs, see layer_names
    DataFile,  ///< the name of a file
  };

  std::string_view keyword;
  std::string_view title;
  std::string_view paper;
  std::string_view description;  ///< what the model is for, and how its parameters change appearance
  std::string_view formula;      ///< the formula as lines of text; directions are in the local frame
  std::string_view example;      ///< a typical instance, for pictures
  std::vector<ParameterInfo> parameters;
  // The reason why the model lacks a property, or the parameters for which it does; empty if it always has
  // the property.
  std::string_view not_isotropic;
  std::string_view not_reciprocal;
  std::string_view not_conserving;
  std::string_view not_continuous;
  ArgumentKind argument_kind = ArgumentKind::Parameters;
  bool takes_maps = false;  ///< images may vary its numbers and colours over faces
  /// Validates values that are each in range together: returns an error message or an empty string. May be
  /// null.
  std::string (*validate)(const Model&) = nullptr;
  /// Returns the largest directional albedo for values that passed `check`; null if unknown.
  LargestAlbedo (*largest_albedo)(const Model&) = nullptr;

  /// Finds a parameter by name or alias, or returns null.
  const ParameterInfo* find(std::string_view word) const;
};

/// The models and sampling schemes that a scene may name.
struct Catalogue {
  std::vector<ModelInfo> brdfs;
  std::vector<ModelInfo> pdfs;
};

/// Finds a model by its keyword, or returns null.
const ModelInfo* find_model(const std::vector<ModelInfo>& models, std::string_view keyword);

/// Finds a model's argument for a parameter, by name or alias, or returns null.
const Argument* find_argument(const Model& model, const ParameterInfo& parameter);

/// Validates a model: reports an unknown keyword, unknown and repeated parameters, and values of the wrong
/// kind or out of range, with their locations and suggestions. `kind` is `BRDF` or `PDF`, for the messages.
/// Returns false if there was an error. `grf/check.h` validates a scene.
bool check(const Model& model, const std::vector<ModelInfo>& models, std::string_view kind,
           Diagnostics& diagnostics);

/// Reports an unknown parameter, lists the parameters that the model has, and, if the value is a word, says
/// what a definition of that name would need.
void report_unknown_parameter(const Argument& argument, const ModelInfo& info, Diagnostics& diagnostics);

/// Reports an unknown model keyword, and suggests similar keywords of models and similar other words.
void report_unknown(const Model& model, const std::vector<ModelInfo>& models, std::string_view kind,
                    const std::vector<std::string>& other_words, Diagnostics& diagnostics);

}  // namespace grf
