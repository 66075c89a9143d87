#pragma once

#include "grf/mesh.h"

namespace convert {

/// Removes the normals of a mesh, so that its faces are flat-shaded, and merges vertices that only differed
/// in normals.
grf::Mesh with_flat_faces(const grf::Mesh& mesh);

/// Recomputes smooth unit normals. Faces that share an edge with a dihedral angle of `crease` (radians, 0 to
/// pi, between their normals) or less are smooth there; over a larger angle the vertex is split. A normal is
/// the mean of those of the smooth faces around the vertex, weighted by their angles there (Thürmer and
/// Wüthrich 1998, Computing vertex normals from polygonal facets). Corners of degenerate faces have none.
grf::Mesh with_smooth_normals(const grf::Mesh& mesh, double crease);

}  // namespace convert
