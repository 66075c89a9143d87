#pragma once

#include <cstddef>

#include "grf/mesh.h"

namespace convert {

struct Welded {
  grf::Mesh mesh;
  std::size_t merged_vertices = 0;  ///< that went to the place of another one, or were like it
  std::size_t collapsed_faces = 0;  ///< left out: fewer than three different places were left of them
};

/// Moves each vertex that is nearer than `distance` (>= 0, in the mesh's own units) to one before it to the
/// nearest of those that stay, so that no two places are nearer than that. Vertices that are then alike
/// become one; where normals, colours or texture coordinates differ, a seam stays, with both its sides at one
/// place. Corners of a face that follow each other at one place become one. Faces of any kind survive, those
/// that make an edge non-manifold too.
Welded weld(const grf::Mesh& mesh, double distance);

}  // namespace convert
