// A parameter table gives the values of a model: those that are written, and defaults for the others.
#pragma once

#include <QString>
#include <optional>

#include "grf/catalogue.h"

namespace editor {

/// The value in force: the written one, else that of the parameter it follows, else the default.
grf::Value value_of(const grf::Model& model, const grf::ModelInfo& info, const grf::ParameterInfo& parameter);

/// True if no value is written for the parameter.
bool is_default(const grf::Model& model, const grf::ParameterInfo& parameter);

/// Sets a value in place of the former one, or appends it.
void set_value(grf::Model& model, const grf::ParameterInfo& parameter, const grf::Value& value);

/// The image that varies a parameter, or nothing.
std::optional<grf::ParameterMap> map_of(const grf::Model& model, const grf::ParameterInfo& parameter);

/// Sets the image, given by its full path, or removes it. The value in force becomes its factor, but 0, which
/// would hide it, becomes the largest value up to 1.
void set_map(grf::Model& model, const grf::ModelInfo& info, const grf::ParameterInfo& parameter,
             const std::optional<grf::ParameterMap>& map);

/// Removes the written value and its image, so that the default applies.
void reset_value(grf::Model& model, const grf::ParameterInfo& parameter);

/// Formats a value as in GRF text.
QString text_of(const grf::Value& value);

/// Help, range, unit and default as lines of rich text.
QString help_of(const grf::ParameterInfo& parameter);

}  // namespace editor
