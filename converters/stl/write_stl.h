#pragma once

#include <string>

#include "grf/diagnostics.h"
#include "grf/scene.h"

namespace convert {

/// Replaces the file by the whole scene as binary STL: triangles that stand in the world, each with the
/// normal of its area. Polygons are cut as for rendering. What STL cannot keep is said, one warning a kind;
/// after an error the file is as it was.
bool write_stl(const grf::Scene& scene, const std::string& path, grf::Diagnostics& diagnostics);

}  // namespace convert
