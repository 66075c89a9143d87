#pragma once

#include <cstddef>
#include <cstdint>

#include "grf/scene.h"

namespace grf {

/// A height field of triangles with a normal for each of its side * side vertices: what most of a large
/// scene's text looks like, about 110 bytes of it a vertex and the two triangles that come with it.
Mesh height_field(std::uint32_t side);

/// A scene of one mesh.
Scene scene_of_mesh(Mesh mesh);

/// What the arrays of a mesh take, without room to grow.
std::size_t bytes_of(const Mesh& mesh);

}  // namespace grf
