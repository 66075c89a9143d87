#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "converters/gltf/gltf_document.h"
#include "converters/gltf/gltf_material_writer.h"
#include "converters/gltf/gltf_mesh_writer.h"
#include "grf/visit.h"

namespace convert {

/// Writes the blocks of a scene without includes as nodes: a node per mesh and light, and one or more parent
/// nodes per transform.
class GltfNodeWriter {
 public:
  GltfNodeWriter(GltfDocument& document, GltfMaterialWriter& materials)
      : document_(document), materials_(materials) {}

  /// Writes blocks and returns the indices of their nodes.
  std::vector<int> write(const grf::BlockList& list);

  /// Moves out the lists of all meshes, in the order of the scene's text.
  nlohmann::json take_lists() { return std::move(lists_); }

 private:
  using Nodes = std::vector<int>;

  void write(const grf::Shared<grf::Mesh>& mesh, Nodes& nodes);
  void write(const grf::MeshLight& light, Nodes& nodes);
  void write(const grf::AreaLight& light, Nodes& nodes);
  void write(const grf::Transform& transform, Nodes& nodes);
  void write(const grf::DefinitionScope& scope, Nodes& nodes);
  void write(const grf::Use& use, Nodes& nodes);
  void write(const grf::Include&, Nodes&) {}
  void write(const grf::Params&, Nodes&) {}

  int add_mesh(const grf::Mesh& mesh, const std::string& name);
  void add_node(int mesh, const std::string& name, Nodes& nodes);

  GltfDocument& document_;
  GltfMaterialWriter& materials_;
  grf::ScopeStack scope_;
  nlohmann::json lists_ = nlohmann::json::array();
  std::unordered_map<const grf::Definition*, int> meshes_;  ///< by definition
};

}  // namespace convert
