#pragma once

#include <cstddef>

#include "grf/mesh.h"

namespace convert {

struct Welded {
  grf::Mesh mesh;
  std::size_t merged_vertices = 0;  ///< vertices moved to the position of another one, or equal to one
  std::size_t collapsed_faces = 0;  ///< faces dropped because fewer than three distinct positions remained
};

/// Welds vertices: moves each vertex nearer than `distance` (>= 0, in object space) to an earlier one to the
/// nearest that stays, so that no two positions are nearer than that. Vertices that are then equal are
/// merged; if normals, colours or texture coordinates differ, a seam stays, with both sides at one position.
/// Consecutive corners of a face at one position are merged. All other faces stay, also those that make an
/// edge non-manifold.
Welded weld(const grf::Mesh& mesh, double distance);

}  // namespace convert
