#pragma once

#include <cstddef>

#include "grf/mesh.h"

namespace convert {

struct Decimated {
  grf::Mesh mesh;
  std::size_t triangles_before = 0;
  std::size_t triangles_wanted = 0;  ///< target; fewer than remain if no more edges could be collapsed
  std::size_t triangles_left_alone = 0;
};

/// Decimates a mesh to about `ratio` (over 0, up to 1) of its triangles, after triangulating its polygons.
/// Edges are collapsed onto one of their ends (half-edge collapse), in the order of their quadric error
/// (Garland and Heckbert 1997, Surface simplification using quadric error metrics), unless a face would flip.
///
/// The remaining vertices are therefore a subset, with the same normals, colours, texture coordinates and
/// irradiance, and faces keep their surfaces. Boundaries and borders between surfaces keep their shape: only
/// vertices in the middle of a straight line are removed from them. A seam of normals or texture coordinates
/// stays one. Faces at non-manifold edges, or with two corners at one position, stay unchanged, and so do
/// their vertices.
Decimated decimate(const grf::Mesh& mesh, double ratio);

}  // namespace convert
