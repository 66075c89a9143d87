#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

#include "grf/comments.h"
#include "grf/math.h"
#include "grf/surface.h"

namespace grf {

/// Whether an array has so much in reserve that it is worth a copy to give it back.
template <class T>
bool has_spare_memory(const std::vector<T>& values) {
  return values.capacity() - values.size() > values.size() / 16;
}

/// Values that some vertices of a mesh have: both arrays are empty while none has one, and else as long as
/// the mesh has vertices.
template <class T>
class OptionalVertexValues {
 public:
  bool empty() const { return values_.empty(); }
  bool has(std::size_t vertex) const { return vertex < present_.size() && present_[vertex]; }
  /// The value of a vertex that has one.
  const T& operator[](std::size_t vertex) const { return values_[vertex]; }

  void set(std::size_t vertex, T value) {
    if (vertex >= values_.size()) resize(vertex + 1);
    values_[vertex] = std::move(value);
    present_[vertex] = true;
  }
  void reserve(std::size_t vertices) {
    values_.reserve(vertices);
    present_.reserve(vertices);
  }
  void free_spare_memory() {
    if (has_spare_memory(values_)) values_.shrink_to_fit();
    present_.shrink_to_fit();
  }

  friend bool operator==(const OptionalVertexValues& a, const OptionalVertexValues& b) {
    const std::size_t size = std::max(a.present_.size(), b.present_.size());
    for (std::size_t i = 0; i < size; ++i) {
      if (a.has(i) != b.has(i) || (a.has(i) && a[i] != b[i])) return false;
    }
    return true;
  }

 private:
  void resize(std::size_t size) {
    values_.resize(size);
    present_.resize(size);
  }

  std::vector<T> values_;
  std::vector<bool> present_;
};

/// What arrives at a vertex from one direction.
struct DirectionalIrradiance {
  Vec3f direction = Vec3f(0);  ///< towards where it comes from, as written, not necessarily of unit length
  Colour irradiance = Colour(0);

  bool operator==(const DirectionalIrradiance&) const = default;
};

/// One value for all directions together, or one for each of a list. W/m2.
using Irradiance = std::variant<Colour, std::vector<DirectionalIrradiance>>;

/// Comments inside a mesh. Those inside the lists of vertices and faces are not kept.
struct MeshComments {
  Comments colour, brdf, pdf, texture, emission;  ///< of the mesh's own attributes
  Comments vertices, faces;                       ///< of the two lists as a whole
  std::vector<std::string> end;                   ///< before `end mesh`

  bool operator==(const MeshComments&) const = default;
};

/// Polygons with shared vertices. A face's index is its place in the file.
///
/// Faces without corners do not exist, corners always index a vertex, and each face always has a surface:
/// whoever fills a mesh goes through `add_face`.
struct Mesh {
  std::string name;  ///< may be empty; not with both plain and typographic (“ ”) quotes
  MeshComments comments;

  std::vector<Vec3f> positions;
  OptionalVertexValues<Vec3f> normals;  ///< as written, not necessarily of unit length
  OptionalVertexValues<Colour> colours;
  OptionalVertexValues<Vec2f> uvs;  ///< where a texture is looked up; (0,0) is the image's lower left corner
  OptionalVertexValues<Irradiance> irradiance;  ///< of a surface that was lit by some earlier computation

  std::vector<std::uint32_t> corners;             ///< vertex indices of all faces, one after the other
  std::vector<std::uint32_t> face_offsets = {0};  ///< where each face's corners begin, and one end

  /// The first surface is what the mesh says before its lists; faces with other attributes have others.
  std::vector<Surface> surfaces = {Surface()};
  std::vector<std::uint32_t> surface_of_face;

  std::size_t face_count() const { return surface_of_face.size(); }
  std::span<const std::uint32_t> face(std::size_t index) const {
    return std::span(corners).subspan(face_offsets[index], face_offsets[index + 1] - face_offsets[index]);
  }
  const Surface& surface(std::size_t face_index) const { return surfaces[surface_of_face[face_index]]; }

  /// Three corners or more, each the index of a vertex, counter-clockwise seen from the front.
  void add_face(std::span<const std::uint32_t> face_corners, std::uint32_t surface_index);

  /// Gives back what the arrays have in reserve.
  void free_spare_memory();

  /// Compares faces by what their surfaces are, not by the order in which the list has them.
  friend bool operator==(const Mesh& a, const Mesh& b);
};

/// Which of a mesh's surfaces its faces have.
std::vector<bool> used_surfaces(const Mesh& mesh);

/// Appends a vertex of another mesh, with all that it has, and gives its index.
std::uint32_t copy_vertex(const Mesh& from, std::uint32_t vertex, Mesh& to);

/// A mesh of some faces of another one, in that order, and of the vertices that they use. Its own surface is
/// the first face's; it has no name and no comments.
Mesh part_of(const Mesh& mesh, std::span<const std::uint32_t> faces);

/// Gives surfaces that are written alike one index in a mesh's list, while the mesh is being filled.
class SurfaceIndex {
 public:
  explicit SurfaceIndex(Mesh& mesh);
  std::uint32_t index_of(const Surface& surface);

 private:
  Mesh* mesh_;
  std::unordered_multimap<std::size_t, std::uint32_t> by_hash_;
};

}  // namespace grf
