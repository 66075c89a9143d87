// A parameter table gives the values of a model: those that are written, and defaults for the others.
#pragma once

#include <QString>

#include "grf/catalogue.h"

namespace editor {

/// The value in force: the written one, else that of the parameter it follows, else the default.
grf::Value value_of(const grf::Model& model, const grf::ModelInfo& info, const grf::ParameterInfo& parameter);

/// True if no value is written for the parameter.
bool is_default(const grf::Model& model, const grf::ParameterInfo& parameter);

/// Sets a value in place of the former one, or appends it.
void set_value(grf::Model& model, const grf::ParameterInfo& parameter, const grf::Value& value);

/// Removes the written value, so that the default applies.
void reset_value(grf::Model& model, const grf::ParameterInfo& parameter);

/// Formats a value as in GRF text.
QString text_of(const grf::Value& value);

/// Help, range, unit and default as lines of rich text.
QString help_of(const grf::ParameterInfo& parameter);

}  // namespace editor
