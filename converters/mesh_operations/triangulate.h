#pragma once

#include "grf/mesh.h"

namespace convert {

/// The mesh with each polygon cut into triangles, which stand in its place and have its surface.
grf::Mesh triangulated(const grf::Mesh& mesh);

}  // namespace convert
