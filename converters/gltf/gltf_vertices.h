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

/// How a mesh stands where it is used (glTF 2.0, sections 3.7.2.2 and 3.7.3).
struct GltfPose {
  std::vector<double> weights;  ///< of the morph targets; those beyond the end are 0
  /// Of a skin: from the mesh to the scene, one for each joint. Empty: there is no skin.
  std::vector<grf::Matrix44d> joints;
};

/// The vertices that a primitive names, before its faces choose among them.
struct GltfVertices {
  std::vector<grf::Vec3f> positions;
  std::vector<grf::Vec3f> normals;  ///< empty, or as many as positions, as are the others
  std::vector<grf::Colour> colours;
  std::vector<grf::Vec2f> uvs;  ///< (0,0) is the image's lower left corner, as in GRF
};

/// What decides a primitive's vertices: primitives that agree in it share them.
struct GltfVertexSource {
  std::map<std::string, int> attributes;
  std::vector<std::map<std::string, int>> targets;
  TextureLookup lookup;

  auto operator<=>(const GltfVertexSource&) const = default;
};

/// Reads the vertices in a pose. Nothing is returned after an error.
std::optional<GltfVertices> read_vertices(const GltfVertexSource& source, const GltfPose& pose,
                                          GltfAccessors& accessors, Losses& losses);

}  // namespace convert
