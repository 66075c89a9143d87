#pragma once

#include <compare>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "converters/gltf/gltf_accessors.h"
#include "converters/gltf/gltf_materials.h"
#include "converters/losses.h"
#include "grf/mesh.h"

namespace convert {

/// The pose of an instance of a mesh: morph weights and skin (glTF 2.0, sections 3.7.2.2 and 3.7.3).
struct GltfPose {
  std::vector<double> weights;  ///< weights of the morph targets; those beyond the end are 0
  /// Joint matrices of a skin, from the mesh to the scene. Empty: there is no skin.
  std::vector<grf::Matrix44d> joints;
};

/// The vertices of a primitive, not yet indexed by its faces.
struct GltfVertices {
  std::vector<grf::Vec3f> positions;
  std::vector<grf::Vec3f> normals;  ///< empty or one per position, as the others
  std::vector<grf::Colour> colours;
  std::vector<grf::Vec2f> uvs;  ///< (0,0) is the image's lower left corner, as in GRF
};

/// The inputs that determine a primitive's vertices: primitives with equal inputs share them.
struct GltfVertexSource {
  std::map<std::string, int> attributes;
  std::vector<std::map<std::string, int>> targets;
  TextureLookup lookup;

  auto operator<=>(const GltfVertexSource&) const = default;
};

/// Reads the vertices in a pose; returns nothing after an error.
std::optional<GltfVertices> read_vertices(const GltfVertexSource& source, const GltfPose& pose,
                                          GltfAccessors& accessors, Losses& losses);

}  // namespace convert
