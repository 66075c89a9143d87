#pragma once

#include "grf/mesh.h"

namespace convert {

/// The mesh without normals, so that its faces are flat. Vertices that only those told apart become one.
grf::Mesh with_flat_faces(const grf::Mesh& mesh);

/// The mesh with normals of its own in place of those that it has. Faces that share an edge and are turned
/// against each other by `crease` (radians, 0 to pi) or less are smooth there; over a larger angle a vertex
/// is split. A normal is the mean of those of the faces that are smooth about the vertex, each weighted by
/// its angle there (Thürmer and Wüthrich 1998, Computing vertex normals from polygonal facets), and of unit
/// length. Corners of faces without an area have none.
grf::Mesh with_smooth_normals(const grf::Mesh& mesh, double crease);

}  // namespace convert
