// What models there are: descriptor tables that the reflectance library fills, and the check of a model
// against them. The table of a model drives the check, command lines, documents and the editor's forms.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grf/diagnostics.h"
#include "grf/model.h"

namespace grf {

enum class ParameterKind {
  Number,
  Reflectance,  ///< a number, or an RGB triple of numbers in the same range
  Boolean,
  Word,  ///< one of `choices`
};

/// How a slider for the parameter should move.
enum class ParameterScale { Linear, Logarithmic };

struct ParameterInfo {
  std::string_view name;
  std::vector<std::string_view> aliases;
  ParameterKind kind = ParameterKind::Number;
  float minimum = 0;
  float maximum = 1;
  float default_value = 0;
  std::optional<Colour> default_rgb;  ///< the default where its channels differ; default_value is the first
  std::vector<std::string_view> choices;  ///< default_value is the index of one
  std::string_view default_from;          ///< the parameter whose value is the default; empty: default_value
  ParameterScale scale = ParameterScale::Linear;
  std::string_view unit;
  std::string_view help;

  bool is_called(std::string_view word) const;
};

/// The most that a surface reflects of light from some direction, as a share of it, and at what angle.
struct LargestAlbedo {
  float albedo = 0;
  float degrees = 0;  ///< from the normal
};

struct ModelInfo {
  /// What may stand behind the keyword, besides parameters.
  enum class Takes {
    Parameters,
    Terms,     ///< weights and names of defined BRDFs
    DataFile,  ///< the name of a file
  };

  std::string_view keyword;
  std::string_view title;
  std::string_view paper;
  std::string_view about;    ///< some sentences: what it is for, and what its parameters do to its looks
  std::string_view formula;  ///< lines as a reader would write them; directions are in the local frame
  std::string_view example;  ///< an instance that shows it well, for pictures
  std::vector<ParameterInfo> parameters;
  // The reason why a model lacks a property, or, of a property that holds for some parameters only, when.
  // Empty: it has the property.
  std::string_view not_isotropic;
  std::string_view not_reciprocal;
  std::string_view not_conserving;
  std::string_view not_continuous;
  Takes takes = Takes::Parameters;
  /// What is wrong with values that are each in range, or nothing; null if nothing can be.
  std::string (*wrong_together)(const Model&) = nullptr;
  /// What values that `check` found right reflect at most; null if nobody knows.
  LargestAlbedo (*largest_albedo)(const Model&) = nullptr;

  const ParameterInfo* find(std::string_view word) const;
};

struct Catalogue {
  std::vector<ModelInfo> brdfs;
  std::vector<ModelInfo> pdfs;
};

const ModelInfo* find_model(const std::vector<ModelInfo>& models, std::string_view keyword);

/// The argument of a model for a parameter, by name or alias, or null.
const Argument* find_argument(const Model& model, const ParameterInfo& parameter);

/// Reports an unknown keyword, unknown and repeated parameters, and values of the wrong kind or out of range,
/// at their place, with the nearest names that exist. `kind` is `BRDF` or `PDF`, for the messages. Returns
/// false if there was an error. `grf/check.h` does so for a scene.
bool check(const Model& model, const std::vector<ModelInfo>& models, std::string_view kind,
           Diagnostics& diagnostics);

/// Says that a model has no such parameter, which it has, and, where the value is a word, what a definition
/// of that name would need.
void report_unknown_parameter(const Argument& argument, const ModelInfo& info, Diagnostics& diagnostics);

/// Says that no model has this keyword, and which of the models and of the other words are near it.
void report_unknown(const Model& model, const std::vector<ModelInfo>& models, std::string_view kind,
                    const std::vector<std::string>& other_words, Diagnostics& diagnostics);

}  // namespace grf
