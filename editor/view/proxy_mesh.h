// Builds proxy meshes, which are drawn in place of large meshes while the camera moves.
#pragma once

#include <cstddef>

#include "editor/view/mesh_geometry.h"

namespace editor {

/// Simplifies a mesh to about so many triangles by vertex clustering on a grid (Rossignac and Borrel 1993,
/// "Multi-resolution 3D approximations for rendering complex scenes"). Each triangle has the face of one that
/// it represents.
TriangleArrays make_proxy_mesh(const TriangleArrays& arrays, std::size_t triangles);

/// Subsamples at most so many triangles evenly from the list: a placeholder until the proxy is built.
TriangleArrays subsampled(const TriangleArrays& arrays, std::size_t triangles);

}  // namespace editor
