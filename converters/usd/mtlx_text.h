#pragma once

#include <string>

#include "converters/usd/usd_scene.h"

namespace convert {

/// Returns a document of MaterialX with the materials of a scene, assigned to the paths of its USD file.
std::string mtlx_text(const UsdScene& scene);

}  // namespace convert
