#pragma once

#include <functional>

#include "converters/gltf/gltf_document.h"
#include "grf/mesh.h"

namespace convert {

/// A mesh that was written.
struct WrittenMesh {
  int mesh = -1;         ///< index of the document's mesh; -1: it has no faces
  nlohmann::json lists;  ///< accessors of its lists (`GltfMeshLists`)
};

/// Writes a mesh: a primitive of triangles per surface, and additional lists for its polygons and vertices.
/// `material_of` returns the material of one of its surfaces.
WrittenMesh write_mesh(const grf::Mesh& mesh, const std::string& name,
                       const std::function<int(const grf::Surface&)>& material_of, GltfDocument& document);

}  // namespace convert
