#include "grf/catalogue.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <variant>

#include <fmt/format.h>

#include "grf/keywords.h"

namespace grf {
namespace {

std::string joined(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, ", "));
}

bool in_range(float value, const ParameterInfo& parameter) {
  return value >= parameter.minimum && value <= parameter.maximum;
}

/// Describes the range of a parameter in words.
std::string range_of(const ParameterInfo& parameter) {
  const bool has_maximum = parameter.maximum < std::numeric_limits<float>::max();
  return has_maximum ? fmt::format("from {} to {}", parameter.minimum, parameter.maximum)
                     : fmt::format("of {} or more", parameter.minimum);
}

std::optional<std::string> wrong_word(const Value& value, const std::vector<std::string_view>& choices) {
  const auto* word = std::get_if<Word>(&value);
  std::vector<std::string> names;
  for (const std::string_view choice : choices) {
    if (word != nullptr && same_keyword(word->text, choice)) return std::nullopt;
    names.emplace_back(choice);
  }
  const std::string expected = "expected one of " + joined(names);
  if (word == nullptr) return expected;
  const std::string suggestion = did_you_mean(word->text, names);
  return fmt::format("'{}' is unknown, {}{}{}", word->text, expected, suggestion.empty() ? "" : ": ",
                     suggestion);
}

/// Returns an error message for an invalid value, or nothing if the value is valid.
std::optional<std::string> wrong_value(const Value& value, const ParameterInfo& parameter) {
  const auto* number = std::get_if<float>(&value);
  if (parameter.kind == ParameterKind::Boolean) {
    const bool zero_or_one = number != nullptr && (*number == 0 || *number == 1);
    if (std::holds_alternative<bool>(value) || zero_or_one) return std::nullopt;
    return "expected true, false, 1 or 0";
  }
  if (parameter.kind == ParameterKind::Word) return wrong_word(value, parameter.choices);
  const std::string range = range_of(parameter);
  const std::string_view kind = parameter.is_whole ? "a whole number" : "a number";
  if (number != nullptr) {
    if (!in_range(*number, parameter))
      return fmt::format("{} is out of range, expected {} {}", *number, kind, range);
    if (parameter.is_whole && *number != std::round(*number))
      return fmt::format("{} is not whole, expected {} {}", *number, kind, range);
    return std::nullopt;
  }
  const auto* colour = std::get_if<Colour>(&value);
  if (parameter.kind != ParameterKind::Reflectance) return fmt::format("expected {} {}", kind, range);
  if (colour == nullptr) return fmt::format("expected a number, or three in parentheses, {}", range);
  for (const float component : {colour->x, colour->y, colour->z}) {
    if (!in_range(component, parameter)) {
      return fmt::format("{} is out of range, expected numbers {}", component, range);
    }
  }
  return std::nullopt;
}

/// Returns an error message for an image that cannot vary a parameter, or nothing if it can.
std::optional<std::string> wrong_map(const Argument& argument, const ParameterInfo& parameter,
                                     const ModelInfo& info) {
  if (!argument.map) return std::nullopt;
  const bool is_colour = parameter.kind == ParameterKind::Reflectance;
  if (!info.takes_maps) return "no image can vary it over faces";
  if ((!is_colour && parameter.kind != ParameterKind::Number) || parameter.is_whole)
    return "an image varies only numbers that need not be whole, and colours";
  if (argument.map->channel == ImageChannel::Rgb && !is_colour)
    return "one number, expected the channel r, g, b or a of the image";
  if (argument.map->file.empty()) return "expected the name of an image";
  return std::nullopt;
}

/// Returns whether an unknown parameter is really the start of a definition that lacks `brdf` or `pdf`: the
/// arguments after it are then that definition's parameters.
bool begins_definition(const Argument& argument, const std::vector<ModelInfo>& models) {
  const auto* word = std::get_if<Word>(&argument.value);
  return word != nullptr && find_model(models, word->text) != nullptr;
}

void check_arguments(const Model& model, const ModelInfo& info, const std::vector<ModelInfo>& models,
                     Diagnostics& diagnostics) {
  std::set<std::string_view> given;
  for (const Argument& argument : model.arguments) {
    const ParameterInfo* parameter = info.find(argument.name);
    if (parameter == nullptr) {
      report_unknown_parameter(argument, info, diagnostics);
      if (begins_definition(argument, models)) return;
    } else if (!given.insert(parameter->name).second) {
      diagnostics.error(argument.location, fmt::format("the parameter '{}' is given twice", parameter->name));
    } else if (const auto wrong_image = wrong_map(argument, *parameter, info)) {
      diagnostics.error(argument.location,
                        fmt::format("'{}' of '{}': {}", parameter->name, info.keyword, *wrong_image));
    } else if (const auto wrong = wrong_value(argument.value, *parameter)) {
      diagnostics.error(argument.location,
                        fmt::format("'{}' of '{}': {}", parameter->name, info.keyword, *wrong));
    }
  }
}

/// Checks constraints between parameters; skipped if a single value is already invalid.
void check_together(const Model& model, const ModelInfo& info, std::size_t errors_before,
                    Diagnostics& diagnostics) {
  if (info.validate == nullptr || diagnostics.error_count() != errors_before) return;
  const std::string wrong = info.validate(model);
  if (!wrong.empty()) diagnostics.error(model.location, fmt::format("'{}': {}", info.keyword, wrong));
}

}  // namespace

bool ParameterInfo::is_called(std::string_view word) const {
  return same_keyword(name, word) ||
         std::any_of(aliases.begin(), aliases.end(),
                     [word](std::string_view alias) { return same_keyword(alias, word); });
}

const ParameterInfo* ModelInfo::find(std::string_view word) const {
  const auto found =
      std::find_if(parameters.begin(), parameters.end(),
                   [word](const ParameterInfo& parameter) { return parameter.is_called(word); });
  return found == parameters.end() ? nullptr : &*found;
}

const ModelInfo* find_model(const std::vector<ModelInfo>& models, std::string_view keyword) {
  const auto found = std::find_if(models.begin(), models.end(), [keyword](const ModelInfo& model) {
    return same_keyword(model.keyword, keyword);
  });
  return found == models.end() ? nullptr : &*found;
}

const Argument* find_argument(const Model& model, const ParameterInfo& parameter) {
  const auto found =
      std::find_if(model.arguments.begin(), model.arguments.end(),
                   [&](const Argument& argument) { return parameter.is_called(argument.name); });
  return found == model.arguments.end() ? nullptr : &*found;
}

void report_unknown_parameter(const Argument& argument, const ModelInfo& info, Diagnostics& diagnostics) {
  std::vector<std::string> names;
  for (const ParameterInfo& known : info.parameters) names.emplace_back(known.name);
  const std::string known = names.empty() ? "it has none" : "it has " + joined(names);
  std::string suggestion = did_you_mean(argument.name, names);
  if (const auto* word = std::get_if<Word>(&argument.value); word != nullptr && suggestion.empty()) {
    suggestion =
        fmt::format("a definition called '{}' needs 'brdf' or 'pdf' before '{}'", argument.name, word->text);
  }
  diagnostics.error(argument.location,
                    fmt::format("'{}' has no parameter '{}', {}{}{}", info.keyword, argument.name, known,
                                suggestion.empty() ? "" : ": ", suggestion));
}

void report_unknown(const Model& model, const std::vector<ModelInfo>& models, std::string_view kind,
                    const std::vector<std::string>& other_words, Diagnostics& diagnostics) {
  std::vector<std::string> candidates = other_words;
  for (const ModelInfo& known : models) candidates.emplace_back(known.keyword);
  const std::string suggestion = did_you_mean(model.keyword, candidates);
  diagnostics.error(model.location, fmt::format("unknown {} '{}'{}{}", kind, model.keyword,
                                                suggestion.empty() ? "" : ": ", suggestion));
}

bool check(const Model& model, const std::vector<ModelInfo>& models, std::string_view kind,
           Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.error_count();
  const ModelInfo* info = find_model(models, model.keyword);
  if (info != nullptr) {
    check_arguments(model, *info, models, diagnostics);
    check_together(model, *info, errors_before, diagnostics);
  } else {
    report_unknown(model, models, kind, {}, diagnostics);
  }
  return diagnostics.error_count() == errors_before;
}

}  // namespace grf
