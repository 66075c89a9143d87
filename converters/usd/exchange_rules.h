#pragma once

#include <span>

#include "converters/material_rule.h"

namespace convert {

/// The tables of what becomes of GRF's surfaces in USD and in MaterialX.
std::span<const MaterialRule> usd_materials();
std::span<const MaterialRule> materialx_materials();

}  // namespace convert
