#pragma once

#include <cstddef>

#include "grf/mesh.h"

namespace convert {

struct Decimated {
  grf::Mesh mesh;
  std::size_t triangles_before = 0;
  std::size_t triangles_wanted = 0;  ///< fewer than there are now where nothing more could go
  std::size_t triangles_left_alone = 0;
};

/// The mesh with about `ratio` (over 0, up to 1) of its triangles, into which polygons are cut first. Edges
/// are collapsed onto one of their ends, in the order of the error that they add (Garland and Heckbert 1997,
/// Surface simplification using quadric error metrics), while no face is turned over.
///
/// So the vertices that are left are some of those that there were, with the same normals, colours, texture
/// coordinates and irradiance, and faces keep their surfaces. Holes, rims and borders between surfaces keep
/// their shape: of the vertices on them, only those in the middle of a straight line go. A seam of normals or
/// texture coordinates stays one. Faces at non-manifold edges, or with two corners at one place, are left
/// alone, and so are their vertices.
Decimated decimate(const grf::Mesh& mesh, double ratio);

}  // namespace convert
