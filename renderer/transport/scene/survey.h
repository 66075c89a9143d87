#pragma once

#include <cstddef>
#include <unordered_map>

#include "grf/scene.h"
#include "grf/visit.h"
#include "renderer/transport/scene/used_vertices.h"

namespace transport {

/// The map of a box, by what it does to the corners.
grf::Box3d transformed(const grf::Box3f& box, const grf::Matrix44d& map);

/// A first look at a scene: which of its meshes are worth an instance, and where it is.
struct Survey {
  /// A mesh that stands at more than one place has that many copies of its triangles made, unless they are
  /// more than this.
  Survey(const grf::Scene& scene, std::size_t most_copied_triangles);

  bool is_instanced(const grf::Mesh& mesh) const { return instanced.contains(&mesh); }

  /// A scene that is small as a file can be large by what it includes many times.
  bool is_too_large() const {
    return triangles > MostTriangles || vertices > MostVertices || surfaces > MostSurfaces ||
           instances > MostInstances;
  }

  /// The vertices that are compiled of a mesh of the scene.
  const UsedVertices& vertices_of(const grf::Mesh& mesh) const { return used_vertices.at(&mesh); }

  /// The box around the vertices of an instanced mesh.
  const grf::Box3f& box_of(const grf::Mesh& mesh) const { return instanced.at(&mesh); }

  static constexpr std::size_t MostTriangles = 200'000'000;
  static constexpr std::size_t MostVertices = 2 * MostTriangles;
  static constexpr std::size_t MostSurfaces = MostTriangles / 4;
  static constexpr std::size_t MostInstances = MostTriangles / 10;

  std::unordered_map<const grf::Mesh*, grf::Box3f> instanced;  ///< with the boxes around their vertices
  std::size_t triangles = 0;                                   ///< those of instanced meshes once
  std::size_t vertices = 0;                                    ///< likewise, those that faces use
  std::size_t surfaces = 0;                                    ///< of each instance and copy
  std::size_t instances = 0;
  std::unordered_map<const grf::Mesh*, UsedVertices> used_vertices;
  /// The centre of a scene that is far from the world's origin for its size, else (0,0,0). Its coordinates
  /// are floats, so that a place of the world that is one differs from it by an exact one.
  grf::Vec3d origin = grf::Vec3d(0);
};

}  // namespace transport
