#pragma once

#include <string>

#include "grf/diagnostics.h"
#include "grf/scene.h"

namespace convert {

/// Writes the whole scene as binary STL: world-space triangles with their geometric normals. Polygons are
/// triangulated as for rendering. Losses are reported in one warning per kind; after an error the file is
/// unchanged.
bool write_stl(const grf::Scene& scene, const std::string& path, grf::Diagnostics& diagnostics);

}  // namespace convert
