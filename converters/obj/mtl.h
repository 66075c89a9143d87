#pragma once

#include <string>
#include <vector>

#include "converters/material_mapping.h"
#include "grf/diagnostics.h"

namespace convert {

/// The materials of a library of OBJ files (`.mtl`), in its order; a name may come twice. What is wrong in it
/// is said in warnings, since the faces are whole without it: values that are none, and a library that cannot
/// be read, of which `asked_for_at` is the place that names it.
std::vector<PhongMaterial> read_mtl(const std::string& path, const grf::SourceLocation& asked_for_at,
                                    grf::Diagnostics& diagnostics);

}  // namespace convert
