// What the mesh operations have in common.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "grf/scene.h"

namespace convert {

/// For each vertex, the first one that is like it: at the same place, with the same normal, colour, texture
/// coordinates and irradiance, bit for bit.
std::vector<std::uint32_t> first_alike(const grf::Mesh& mesh);

/// For each vertex, the first one at the same place with the same value of one kind.
template <class Value>
std::vector<std::uint32_t> first_with_value(const grf::Geometry& geometry,
                                            grf::OptionalVertexValues<Value> grf::Geometry::*values) {
  grf::MeshDraft of_one_kind;
  of_one_kind.positions = geometry.positions;
  of_one_kind.*values = geometry.*values;
  return first_alike(std::move(of_one_kind));
}

/// Faces of a mesh with other corners, before they are a mesh themselves. The name, the comments and the
/// surfaces are those of the mesh.
class Rebuild {
 public:
  /// The mesh outlives this.
  explicit Rebuild(const grf::Mesh& source);

  /// Corners are vertices of the source.
  void add_face(std::span<const std::uint32_t> corners, std::uint32_t surface);

  /// The mesh of these faces. It has the vertices that they use, in the order of the source.
  grf::Mesh take();

 private:
  const grf::Mesh& source_;
  grf::MeshDraft mesh_;
};

/// A mesh without vertices and faces that is else like another one.
grf::MeshDraft without_geometry(const grf::Mesh& mesh);

}  // namespace convert
