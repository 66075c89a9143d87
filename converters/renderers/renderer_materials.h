#pragma once

#include <span>

#include "converters/material_rule.h"

namespace convert {

/// The tables of what becomes of GRF's surfaces in other renderers.
std::span<const MaterialRule> pbrt_materials();
std::span<const MaterialRule> mitsuba_materials();

}  // namespace convert
