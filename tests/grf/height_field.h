#pragma once

#include <cstddef>
#include <cstdint>

#include "grf/scene.h"

namespace grf {

/// Makes a height field of triangles with a normal per vertex, side * side vertices: typical text of a large
/// scene, with about 110 bytes per vertex and its two triangles.
Mesh height_field(std::uint32_t side);

/// Makes a scene of one mesh.
Scene scene_of_mesh(Mesh mesh);

/// Returns the size of a mesh's arrays in bytes, without spare capacity.
std::size_t bytes_of(const Mesh& mesh);

}  // namespace grf
