#pragma once

#include "grf/mesh.h"

namespace convert {

/// The mesh with its vertices moved towards the mean of their neighbours, in so many steps, so that noise and
/// small features go (G. Taubin 1995, "A signal processing approach to fair surface design"). Each step is a
/// Laplacian one by 0.5 and one back, with a pass-band frequency of 0.1, so that the surface hardly shrinks.
///
/// Faces keep their surfaces, and vertices all that they have but normals, which are computed anew and stay
/// shared or apart as they were. Boundaries stay where they are, and so do edges of more than two faces and
/// vertices where parts of a surface meet without an edge.
grf::Mesh smoothed(const grf::Mesh& mesh, int steps);

}  // namespace convert
