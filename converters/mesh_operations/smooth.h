#pragma once

#include "grf/mesh.h"

namespace convert {

/// Smooths a mesh in a number of steps, which removes noise and small features (G. Taubin 1995, "A signal
/// processing approach to fair surface design"). Each step is a Laplacian step by 0.5 and one back, with a
/// pass-band frequency of 0.1, so that the surface hardly shrinks.
///
/// Faces keep their surfaces, and vertices their attributes except normals, which are recomputed and stay
/// shared or split as they were. Boundaries, non-manifold edges and non-manifold vertices stay in place.
grf::Mesh smoothed(const grf::Mesh& mesh, int steps);

}  // namespace convert
