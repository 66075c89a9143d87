#pragma once

#include <cstdint>

#include "grf/mesh.h"

namespace convert {

enum class SubdivisionScheme {
  /// C. Loop 1987, "Smooth Subdivision Surfaces Based on Triangles": each triangle becomes four. Polygons are
  /// cut into triangles first.
  Loop,
  /// E. Catmull and J. Clark 1978, "Recursively generated B-spline surfaces on arbitrary topological meshes":
  /// each face becomes as many quadrilaterals as it has corners.
  CatmullClark
};

struct Subdivision {
  SubdivisionScheme scheme = SubdivisionScheme::CatmullClark;
  int levels = 1;  ///< how many times, 0 or more
};

/// How many faces the mesh will have. A mesh has room for `MostSubdividedFaces`, which is checked before it
/// is subdivided.
double faces_after(const grf::Mesh& mesh, const Subdivision& subdivision);
inline constexpr double MostSubdividedFaces = 1e9;

/// The mesh with finer faces, whose vertices approach a smooth surface. A face's children follow each other
/// and have its surface.
///
/// Boundaries become cubic B-spline curves, which depend on nothing but themselves, so that two meshes along
/// one boundary stay together. Edges of more than two faces are treated like boundaries, and vertices where
/// parts of a surface meet without an edge stay where they are. Vertices at one place stay at one place.
/// Texture coordinates and colours are subdivided by the same masks where the surface has no seam of them,
/// and are interpolated linearly along seams. Where vertices have normals, all get new ones, since the
/// surface is smooth; without normals it stays without. Irradiance is left out: it belongs to other points.
///
/// OpenMesh's subdividers are not used: they know no seams and no edges of three faces, and its Catmull-Clark
/// has boundaries that are no B-splines.
grf::Mesh subdivided(const grf::Mesh& mesh, const Subdivision& subdivision);

}  // namespace convert
