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

/// A corner of a face with all that belongs to it.
struct Corner {
  grf::Vec3f position;
  std::optional<grf::Vec3f> normal;
  std::optional<grf::Colour> colour;
  std::optional<grf::Vec2f> uv;
};

/// Makes a mesh of faces whose corners are given one by one: corners that are alike share a vertex, which
/// means that their numbers are equal, bit for bit but for the sign of a zero; the first of them is kept.
/// Vertices and faces keep the order in which they come.
class MeshBuilder {
 public:
  explicit MeshBuilder(std::string name);
  MeshBuilder(const MeshBuilder&) = delete;  // surfaces_ points to mesh_
  MeshBuilder& operator=(const MeshBuilder&) = delete;

  /// The index under which `add_face` knows a surface. The first one becomes that of the mesh as a whole.
  std::uint32_t surface(const grf::Surface& surface);

  /// Three corners or more, counter-clockwise seen from the front.
  void add_face(std::span<const Corner> corners, std::uint32_t surface);

  /// The vertex that corners like this one share, for readers that know which corners are alike.
  std::uint32_t vertex(const Corner& corner);
  /// The same face, of vertices that are known.
  void add_face(std::span<const std::uint32_t> vertices, std::uint32_t surface);

  std::size_t face_count() const { return mesh_.face_count(); }

  /// The mesh; the builder is of no use afterwards.
  grf::Mesh take();

 private:
  bool is_alike(std::uint32_t vertex, const Corner& corner) const;

  grf::MeshDraft mesh_;
  std::optional<grf::SurfaceIndex> surfaces_;
  IndexTable vertices_;
  std::vector<std::uint32_t> face_;
};

}  // namespace convert
