// Our glTF files carry a GRF scene in their extras, for all that glTF cannot represent. It is GRF text,
// except for the lists of meshes, which are accessors.
#pragma once

#include <optional>
#include <string>

#include "converters/gltf/gltf_accessors.h"
#include "converters/gltf/gltf_file.h"
#include "grf/scene.h"

namespace convert {

/// Returns a mesh with the same name, comments and surfaces, but only one triangle per surface that faces
/// use.
grf::Mesh without_lists(const grf::Mesh& mesh);

/// The accessors of the lists of a mesh, as members of an object in the extras. Accessors with no information
/// are absent.
struct GltfMeshLists {
  std::size_t vertices = 0;
  std::size_t faces = 0;
  std::optional<int> positions, normals, colours, uvs;
  std::optional<int> present;  ///< a byte per vertex, bits as below; absent: attributes are on all vertices
  std::optional<int> irradiance;                              ///< an RGB value per vertex
  std::optional<int> ray_counts, ray_directions, ray_values;  ///< the first an integer per vertex
  std::optional<int> corners;
  std::optional<int> sizes;     ///< corners per face; absent: 3
  std::optional<int> surfaces;  ///< per face, the index of its triangle in `without_lists`; absent: 0
};

// Bits of the attributes of a vertex.
inline constexpr unsigned HasNormal = 1;
inline constexpr unsigned HasColour = 2;
inline constexpr unsigned HasUv = 4;
inline constexpr unsigned HasIrradiance = 8;
inline constexpr unsigned HasRays = 16;

/// Calls `member` with the name and the index of each accessor.
template <class Lists, class Member>
void for_each_list(Lists& lists, const Member& member) {
  member("positions", lists.positions);
  member("normals", lists.normals);
  member("colours", lists.colours);
  member("uvs", lists.uvs);
  member("present", lists.present);
  member("irradiance", lists.irradiance);
  member("rayCounts", lists.ray_counts);
  member("rayDirections", lists.ray_directions);
  member("rayValues", lists.ray_values);
  member("corners", lists.corners);
  member("sizes", lists.sizes);
  member("surfaces", lists.surfaces);
}

/// Reads the scene in the extras of an unchanged file. Returns nothing after an error.
std::optional<grf::Scene> read_grf_extras(const GltfFile& file, GltfAccessors& accessors,
                                          grf::Diagnostics& diagnostics);

}  // namespace convert
