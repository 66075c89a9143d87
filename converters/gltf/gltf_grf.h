// The scene of GRF that a glTF file of ours carries in its extras: all that glTF cannot say. Its text stands
// there as GRF, but for the lists of meshes, which are accessors.
#pragma once

#include <optional>
#include <string>

#include "converters/gltf/gltf_accessors.h"
#include "converters/gltf/gltf_file.h"
#include "grf/scene.h"

namespace convert {

/// A mesh with the same name, comments and surfaces, but one triangle for each surface that faces have.
grf::Mesh without_lists(const grf::Mesh& mesh);

/// Where the lists of a mesh are in a file, as members of an object in its extras. Accessors are absent where
/// there is nothing to say.
struct GltfMeshLists {
  std::size_t vertices = 0;
  std::size_t faces = 0;
  std::optional<int> positions, normals, colours, uvs;
  std::optional<int> present;  ///< a byte a vertex, bits as below; absent: all vertices have what some have
  std::optional<int> irradiance;                              ///< an RGB value a vertex
  std::optional<int> ray_counts, ray_directions, ray_values;  ///< the first an integer a vertex
  std::optional<int> corners;
  std::optional<int> sizes;     ///< corners of each face; absent: 3
  std::optional<int> surfaces;  ///< of each face, the place of its triangle in `without_lists`; absent: 0
};

// Bits of what a vertex has.
inline constexpr unsigned HasNormal = 1;
inline constexpr unsigned HasColour = 2;
inline constexpr unsigned HasUv = 4;
inline constexpr unsigned HasIrradiance = 8;
inline constexpr unsigned HasRays = 16;

/// Calls `member` with the name and the place of each accessor.
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

/// The scene in the extras of a file that was not changed since. Nothing is returned after an error.
std::optional<grf::Scene> read_grf_extras(const GltfFile& file, GltfAccessors& accessors,
                                          grf::Diagnostics& diagnostics);

}  // namespace convert
