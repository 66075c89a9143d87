#pragma once

#include <optional>

#include "converters/gltf/gltf_vertices.h"

namespace convert {

/// Converts a glTF mesh to GRF: the faces of all its primitives, in order. Unused vertices are dropped.
/// Returns nothing after an error.
std::optional<grf::Mesh> read_mesh(const tinygltf::Mesh& source, const GltfPose& pose,
                                   GltfAccessors& accessors, GltfMaterials& materials, Losses& losses);

}  // namespace convert
