#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "grf/math.h"

namespace grf {

struct Topology;
struct GeometryFacts;
class SharedEdges;
class VertexTree;

/// Returns whether an array's spare capacity is worth a copy to free it.
template <class T>
bool has_spare_memory(const std::vector<T>& values) {
  return values.capacity() - values.size() > values.size() / 16;
}

/// A vertex attribute that only some vertices of a mesh have: both arrays are empty while no vertex has it,
/// and else have one entry per vertex.
template <class T>
class OptionalVertexValues {
 public:
  bool empty() const { return values_.empty(); }  ///< Returns whether no vertex, or this one, has a value.
  bool has(std::size_t vertex) const { return vertex < present_.size() && present_[vertex]; }
  /// Returns the value of a vertex that has one.
  const T& operator[](std::size_t vertex) const { return values_[vertex]; }

  /// Gives a vertex its value.
  void set(std::size_t vertex, T value) {
    if (vertex >= values_.size()) resize(vertex + 1);
    values_[vertex] = std::move(value);
    present_[vertex] = true;
  }
  /// Reserves memory for the values of so many vertices.
  void reserve(std::size_t vertices) {
    values_.reserve(vertices);
    present_.reserve(vertices);
  }
  /// Frees memory that values do not need.
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

/// The geometry of a mesh: polygons with shared vertices. Faces are in the order of the file. Each has three
/// corners or more, and corners always index a vertex.
struct Geometry {
  std::vector<Vec3f> positions;
  OptionalVertexValues<Vec3f> normals;  ///< as written, not necessarily of unit length
  OptionalVertexValues<Colour> colours;
  OptionalVertexValues<Vec2f> uvs;  ///< texture coordinates; (0,0) is the image's lower left corner

  std::vector<std::uint32_t> corners;             ///< vertex indices of all faces, concatenated
  std::vector<std::uint32_t> face_offsets = {0};  ///< the first corner of each face, and one past the last

  /// Returns the number of faces, or the vertices of one.
  std::size_t face_count() const { return face_offsets.size() - 1; }
  std::span<const std::uint32_t> face(std::size_t index) const {
    return std::span(corners).subspan(face_offsets[index], face_offsets[index + 1] - face_offsets[index]);
  }
  /// Returns the number of triangles in a triangulation of all faces.
  std::size_t triangle_count() const { return corners.size() - 2 * face_count(); }

  /// Appends a face of three corners or more, vertex indices in counter-clockwise order seen from the front.
  void add_face(std::span<const std::uint32_t> face_corners);
  /// Reverses the orientation of a face; its first corner stays the first.
  void reverse_face(std::size_t index);

  /// Frees the spare capacity of the arrays.
  void free_spare_memory();

  bool operator==(const Geometry&) const = default;
};

/// Computes twice the area of a face under a transform, as a vector along its normal (Newell's method), for
/// any polygon.
Vec3d doubled_area_vector(std::span<const std::uint32_t> face, std::span<const Vec3f> positions,
                          const Matrix44d& to_world = {});
inline Vec3d doubled_area_vector(const Geometry& geometry, std::size_t face, const Matrix44d& to_world) {
  return doubled_area_vector(geometry.face(face), geometry.positions, to_world);
}
/// Returns whether a face has more area than rounding leaves to one without: over 1e-7 of the square of its
/// longest edge. `doubled_area` is its `doubled_area_vector`, untransformed.
bool has_area(const Geometry& geometry, std::size_t face, const Vec3d& doubled_area);
/// Returns whether all corners of a face have vertex normals that point away from its front.
bool has_normals_behind(const Geometry& geometry, std::size_t face, const Vec3d& doubled_area);

/// Computes the total area of all faces under a transform.
double area_of(const Geometry& geometry, const Matrix44d& to_world);

/// A triangulation of the faces of a geometry, in the order of the faces.
class Triangulation {
 public:
  /// Triangulates a geometry, which must outlive this at the same address.
  explicit Triangulation(const Geometry& geometry);

  std::size_t size() const { return geometry_->triangle_count(); }  ///< Returns the number of triangles.
  /// Returns the vertex indices of a triangle, counter-clockwise seen from the front.
  std::array<std::uint32_t, 3> operator[](std::size_t triangle) const {
    if (!triangles_.empty()) return triangles_[triangle];
    const std::uint32_t* corner = geometry_->corners.data() + 3 * triangle;
    return {corner[0], corner[1], corner[2]};
  }
  /// Returns the first triangle of a face; its triangles end where those of the next face begin.
  std::size_t first_of(std::size_t face) const { return geometry_->face_offsets[face] - 2 * face; }

 private:
  const Geometry* geometry_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;  ///< empty if all faces are triangles already
};

/// An immutable geometry, shared by its copies. Derived data is computed on first use and cached; this is
/// thread-safe.
class SharedGeometry {
 public:
  SharedGeometry();                   ///< without faces
  SharedGeometry(Geometry geometry);  // NOLINT: a value is one of its kind

  const Geometry& operator*() const { return *geometry_; }
  const Geometry* operator->() const { return geometry_.get(); }

  const VertexTree& vertices() const;  ///< with the bounds of the geometry
  const Triangulation& triangulation() const;
  const Topology& topology() const;
  /// Returns the edges between places: vertices at the same position count as one.
  const SharedEdges& edges() const;
  /// Returns `doubled_area_vector` of each face, untransformed.
  const std::vector<Vec3f>& area_vectors() const;
  double area() const;  ///< of all faces, untransformed

  /// Returns whether both share the same data, which takes no comparison of values.
  bool shares(const SharedGeometry& other) const { return geometry_ == other.geometry_; }
  friend bool operator==(const SharedGeometry& a, const SharedGeometry& b) { return a.shares(b) || *a == *b; }

 private:
  const GeometryFacts& facts() const;

  std::shared_ptr<const Geometry> geometry_;  ///< the base of a GeometryFacts
};

}  // namespace grf
