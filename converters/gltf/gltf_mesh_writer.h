#pragma once

#include <functional>

#include "converters/gltf/gltf_document.h"
#include "grf/mesh.h"

namespace convert {

/// A mesh as it was written.
struct WrittenMesh {
  int mesh = -1;         ///< its place among the document's meshes; -1: it has no faces
  nlohmann::json lists;  ///< where its lists are (`GltfMeshLists`)
};

/// Writes a mesh: a primitive for each surface, of triangles, and what those do not say of its polygons and
/// vertices in lists of its own. `material_of` gives the material of one of its surfaces.
WrittenMesh write_mesh(const grf::Mesh& mesh, const std::string& name,
                       const std::function<int(const grf::Surface&)>& material_of, GltfDocument& document);

}  // namespace convert
