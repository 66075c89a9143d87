// Functions that the mesh operations share.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "grf/scene.h"

namespace convert {

/// Returns, for each vertex, the first equal one: with the same position, normal, colour, texture coordinates
/// and irradiance, bit for bit.
std::vector<std::uint32_t> first_equal_vertex(const grf::Mesh& mesh);

/// Returns, for each vertex, the first one with the same position and value of one attribute.
template <class Value>
std::vector<std::uint32_t> first_with_value(const grf::Geometry& geometry,
                                            grf::OptionalVertexValues<Value> grf::Geometry::*values) {
  grf::MeshDraft of_one_kind;
  of_one_kind.positions = geometry.positions;
  of_one_kind.*values = geometry.*values;
  return first_equal_vertex(std::move(of_one_kind));
}

/// A builder of a mesh with new faces of an existing mesh's vertices. Name, comments and surfaces are those
/// of the source.
class Rebuild {
 public:
  /// Starts without faces; the source must outlive this.
  explicit Rebuild(const grf::Mesh& source);

  /// Adds a face; corners are vertices of the source.
  void add_face(std::span<const std::uint32_t> corners, std::uint32_t surface);

  /// Moves out the mesh. It has the vertices that its faces use, in the order of the source.
  grf::Mesh take();

 private:
  const grf::Mesh& source_;
  grf::MeshDraft mesh_;
};

/// Copies a mesh without its vertices and faces.
grf::MeshDraft without_geometry(const grf::Mesh& mesh);

}  // namespace convert
