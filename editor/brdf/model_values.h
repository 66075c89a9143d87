// Values of a model by its descriptor table: those that are written, and the defaults of those that are not.
#pragma once

#include <QString>

#include "grf/catalogue.h"

namespace editor {

/// The value that holds: the one that is written, else that of the parameter it follows, else the default.
grf::Value value_of(const grf::Model& model, const grf::ModelInfo& info, const grf::ParameterInfo& parameter);

/// True if nothing is written for the parameter, so that its default holds.
bool is_default(const grf::Model& model, const grf::ParameterInfo& parameter);

/// Writes a value in the place of the former one, or behind the others.
void set_value(grf::Model& model, const grf::ParameterInfo& parameter, const grf::Value& value);

/// Takes away what is written.
void reset_value(grf::Model& model, const grf::ParameterInfo& parameter);

/// As a reader would write it.
QString text_of(const grf::Value& value);

/// Help, range, unit and default in some lines.
QString help_of(const grf::ParameterInfo& parameter);

}  // namespace editor
