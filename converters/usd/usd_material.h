#pragma once

#include <string>

#include "converters/usd/exchange_material.h"
#include "converters/usd/usd_text.h"

namespace convert {

/// Puts a material as a prim in the prim with this path: a UsdPreviewSurface, and nodes of MaterialX.
void put_usd_material(UsdText& text, const std::string& parent, const ExchangeMaterial& material);

}  // namespace convert
