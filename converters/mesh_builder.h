#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "converters/index_table.h"
#include "grf/mesh.h"

namespace convert {

/// A corner of a face with its vertex attributes.
struct Corner {
  grf::Vec3f position;
  std::optional<grf::Vec3f> normal;
  std::optional<grf::Colour> colour;
  std::optional<grf::Vec2f> uv;
};

/// Builds an indexed mesh from faces with unindexed corners: equal corners share a vertex, where equal means
/// bit for bit but for the sign of a zero; the first of them is kept. Vertices and faces keep the order of
/// addition.
class MeshBuilder {
 public:
  explicit MeshBuilder(std::string name);
  MeshBuilder(const MeshBuilder&) = delete;  // surfaces_ points to mesh_
  MeshBuilder& operator=(const MeshBuilder&) = delete;

  /// Returns the index of a surface for `add_face`. The first surface becomes that of the mesh itself.
  std::uint32_t surface(const grf::Surface& surface);

  /// Adds a face of three corners or more, counter-clockwise seen from the front.
  void add_face(std::span<const Corner> corners, std::uint32_t surface);

  /// Returns the shared vertex of corners equal to this one, for readers that know which corners are equal.
  std::uint32_t vertex(const Corner& corner);
  /// Adds a face of known vertices.
  void add_face(std::span<const std::uint32_t> vertices, std::uint32_t surface);

  /// Returns the number of faces that were added.
  std::size_t face_count() const { return mesh_.face_count(); }

  /// Moves the mesh out of the builder, which must not be used afterwards.
  grf::Mesh take();

 private:
  bool is_equal(std::uint32_t vertex, const Corner& corner) const;

  grf::MeshDraft mesh_;
  std::optional<grf::SurfaceIndex> surfaces_;
  IndexTable vertices_;
  std::vector<std::uint32_t> face_;
};

}  // namespace convert
