// What is drawn in place of a large mesh while the camera moves.
#pragma once

#include <cstddef>

#include "editor/view/mesh_geometry.h"

namespace editor {

/// About so many triangles that look like the mesh from afar: its vertices brought together in the cells of a
/// grid (Rossignac and Borrel 1993, "Multi-resolution 3D approximations for rendering complex scenes"). Each
/// triangle has the face of one that it stands for.
TriangleArrays stand_in(const TriangleArrays& arrays, std::size_t triangles);

/// At most so many triangles of the mesh, evenly chosen from its list: for the time until a stand-in is made.
TriangleArrays thinned(const TriangleArrays& arrays, std::size_t triangles);

}  // namespace editor
