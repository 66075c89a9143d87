#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "grf/mesh.h"

namespace convert {

/// A corner of a face with all that belongs to it.
struct Corner {
  grf::Vec3f position;
  std::optional<grf::Vec3f> normal;
  std::optional<grf::Colour> colour;
  std::optional<grf::Vec2f> uv;
};

/// Makes a mesh of faces whose corners are given one by one: corners that are alike, bit for bit, share a
/// vertex. Vertices and faces keep the order in which they come.
class MeshBuilder {
 public:
  explicit MeshBuilder(std::string name);
  MeshBuilder(const MeshBuilder&) = delete;  // surfaces_ points to mesh_
  MeshBuilder& operator=(const MeshBuilder&) = delete;

  /// The index under which `add_face` knows a surface. The first one becomes that of the mesh as a whole.
  std::uint32_t surface(const grf::Surface& surface);

  /// Three corners or more, counter-clockwise seen from the front.
  void add_face(std::span<const Corner> corners, std::uint32_t surface);

  std::size_t face_count() const { return mesh_.face_count(); }

  /// The mesh; the builder is of no use afterwards.
  grf::Mesh take() { return std::move(mesh_); }

 private:
  /// The bits of position, normal, colour and uv, and which of the latter there are.
  using Key = std::array<std::uint32_t, 12>;
  struct KeyHash {
    std::size_t operator()(const Key& key) const;
  };

  static Key key_of(const Corner& corner);
  std::uint32_t vertex(const Corner& corner);

  grf::Mesh mesh_;
  std::optional<grf::SurfaceIndex> surfaces_;
  std::unordered_map<Key, std::uint32_t, KeyHash> vertices_;
  std::vector<std::uint32_t> face_;
};

}  // namespace convert
