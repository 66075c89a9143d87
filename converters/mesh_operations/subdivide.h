#pragma once

#include <cstdint>

#include "grf/mesh.h"

namespace convert {

enum class SubdivisionScheme {
  /// C. Loop 1987, "Smooth Subdivision Surfaces Based on Triangles": each triangle becomes four. Polygons are
  /// triangulated first.
  Loop,
  /// E. Catmull and J. Clark 1978, "Recursively generated B-spline surfaces on arbitrary topological meshes":
  /// each face becomes as many quadrilaterals as it has corners.
  CatmullClark
};

struct Subdivision {
  SubdivisionScheme scheme = SubdivisionScheme::CatmullClark;
  int levels = 1;  ///< number of refinement steps, 0 or more
};

/// Computes the number of faces after subdivision, to check it against the limit `MostSubdividedFaces`
/// before.
double faces_after(const grf::Mesh& mesh, const Subdivision& subdivision);
inline constexpr double MostSubdividedFaces = 1e9;

/// Subdivides a mesh. Its vertices approach the smooth limit surface; a face's children are consecutive and
/// have its surface.
///
/// Boundaries become cubic B-spline curves that depend only on the boundary, so that meshes that share one
/// stay together. Non-manifold edges are treated like boundaries, and non-manifold vertices stay in place.
/// Vertices at one position stay at one position. Texture coordinates and colours use the same masks where
/// they have no seam, and are interpolated linearly along seams. If vertices have normals, all get new ones,
/// since the surface is smooth; without normals it stays without. Irradiance is dropped: it belongs to other
/// points.
///
/// OpenMesh's subdividers are not used: they support neither seams nor non-manifold edges, and its
/// Catmull-Clark boundaries are no B-splines.
grf::Mesh subdivided(const grf::Mesh& mesh, const Subdivision& subdivision);

}  // namespace convert
