#pragma once

#include <optional>

#include "converters/gltf/gltf_vertices.h"

namespace convert {

/// Makes a mesh of GRF of one of a glTF file: the faces of all its primitives that have some, in their order.
/// Vertices that no face uses are left out. Nothing is returned after an error.
std::optional<grf::Mesh> read_mesh(const tinygltf::Mesh& source, const GltfPose& pose,
                                   GltfAccessors& accessors, GltfMaterials& materials, Losses& losses);

}  // namespace convert
