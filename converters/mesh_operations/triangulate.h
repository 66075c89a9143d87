#pragma once

#include "grf/mesh.h"

namespace convert {

/// Triangulates each polygon of a mesh in place; triangles have its surface.
grf::Mesh triangulated(const grf::Mesh& mesh);

}  // namespace convert
