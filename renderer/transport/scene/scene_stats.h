#pragma once

#include <cstddef>
#include <unordered_map>

#include "grf/scene.h"
#include "grf/visit.h"
#include "renderer/transport/scene/used_vertices.h"

namespace transport {

/// Returns the bounds of a box whose corners are transformed by a map.
grf::Box3d transformed(const grf::Box3f& box, const grf::Matrix44d& map);

/// Statistics of a scene before compilation: its origin, its size, and which meshes to instance.
struct SceneStats {
  /// A mesh that is placed more than once is copied, unless all copies together have more triangles than
  /// this.
  SceneStats(const grf::Scene& scene, std::size_t most_copied_triangles);

  bool is_instanced(const grf::Mesh& mesh) const { return instanced.contains(&mesh); }

  /// Whether the scene exceeds the limits; a small file can include others many times.
  bool is_too_large() const {
    return triangles > MostTriangles || vertices > MostVertices || surfaces > MostSurfaces ||
           instances > MostInstances;
  }

  /// The vertices of a mesh that are compiled.
  const UsedVertices& vertices_of(const grf::Mesh& mesh) const { return used_vertices.at(&mesh); }

  /// The bounding box of an instanced mesh.
  const grf::Box3f& box_of(const grf::Mesh& mesh) const { return instanced.at(&mesh); }

  static constexpr std::size_t MostTriangles = 200'000'000;
  static constexpr std::size_t MostVertices = 2 * MostTriangles;
  static constexpr std::size_t MostSurfaces = MostTriangles / 4;
  static constexpr std::size_t MostInstances = MostTriangles / 10;

  std::unordered_map<const grf::Mesh*, grf::Box3f> instanced;  ///< with the bounding boxes of their vertices
  std::size_t triangles = 0;                                   ///< those of instanced meshes once
  std::size_t vertices = 0;                                    ///< likewise, those that faces use
  std::size_t surfaces = 0;                                    ///< of each instance and copy
  std::size_t instances = 0;
  std::unordered_map<const grf::Mesh*, UsedVertices> used_vertices;
  /// The centre of a scene that is far from the world's origin for its size, else (0,0,0). Its coordinates
  /// are floats, so that subtracting it from a position of float coordinates is exact.
  grf::Vec3d origin = grf::Vec3d(0);
};

}  // namespace transport
