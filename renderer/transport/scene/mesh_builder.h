#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "grf/mesh.h"
#include "renderer/transport/effect.h"
#include "renderer/transport/lights/emitter.h"
#include "renderer/transport/scene/geometry.h"
#include "renderer/transport/scene/surface_point.h"
#include "renderer/transport/scene/used_vertices.h"

namespace transport {

bool mirrors(const grf::Matrix44d& map);

/// The size of a triangle mesh, and the optional vertex attributes that it has.
struct MeshSize {
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  bool has_normals = false;
  bool has_colours = false;
  bool has_uvs = false;
  bool has_irradiance = false;

  /// Adds a mesh's size; of vertex attributes, only those that these effects need.
  void add(const grf::Mesh& mesh, const UsedVertices& used, bool needs_uvs, const EffectSet& effects);
};

/// Triangulates polygons. All memory is reserved at once, and faces of three or four corners allocate nothing
/// more.
class MeshBuilder {
 public:
  explicit MeshBuilder(const MeshSize& size);

  /// Adds all faces, and the vertices that they use, transformed by a map; their surfaces are the scene's
  /// from `first_surface` on.
  void add(const grf::Mesh& mesh, const UsedVertices& used, const grf::Matrix44d& map,
           std::span<const CompiledSurface> surfaces, std::uint32_t first_surface);
  /// Adds a parallelogram, as two triangles.
  void add(const Emitter& light, std::uint32_t surface);

  const TriangleMesh& mesh() const { return mesh_; }
  TriangleMesh finish();

 private:
  void add_vertices(const grf::Mesh& mesh, const UsedVertices& used, const grf::Matrix44d& map);
  void add_normals(const grf::Mesh& mesh, const UsedVertices& used, const grf::Matrix44d& map);
  bool is_flat(const std::array<std::uint32_t, 3>& corners) const;
  void add_triangle(const Triangle& triangle, bool emits);

  MeshSize size_;
  TriangleMesh mesh_;
  std::uint32_t emitting_triangles_ = 0;
  std::uint32_t last_emitting_triangle_ = 0;
};

}  // namespace transport
