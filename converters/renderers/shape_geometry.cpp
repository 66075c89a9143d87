#include "converters/renderers/shape_geometry.h"

#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace convert {
namespace {

using Corners = std::array<std::uint32_t, 3>;

constexpr std::uint32_t NoVertex = std::numeric_limits<std::uint32_t>::max();

/// Builds the mesh of one shape.
class ShapeMaker {
 public:
  ShapeMaker(const RenderShape& shape, const GeometryNeeds& needs)
      : shape_(shape),
        geometry_(*shape.mesh->geometry),
        needs_(needs),
        normals_to_world_(shape.to_world.inverse().transposed()),
        new_vertex_(geometry_.positions.size(), NoVertex) {
    find_triangles();
  }

  grf::MeshDraft make();

 private:
  void find_triangles();
  bool lacks_normal(const Corners& corners) const;
  grf::Vec3d position(std::uint32_t vertex) const {
    return grf::Vec3d(geometry_.positions[vertex]) * shape_.to_world;
  }
  grf::Vec3d area_vector(const Corners& corners) const;
  std::uint32_t add_vertex(std::uint32_t vertex, const grf::Vec3f* normal);
  std::uint32_t shared_vertex(std::uint32_t vertex);
  void add_triangle(const Corners& corners);
  void add_tangents(const Corners& corners, const Corners& added);

  const RenderShape& shape_;
  const grf::Geometry& geometry_;
  const GeometryNeeds& needs_;
  grf::Matrix44d normals_to_world_;
  std::vector<std::uint32_t> new_vertex_;
  std::vector<Corners> triangles_;
  bool is_smooth_ = false;  ///< whether any triangle has normals of vertices
  bool has_tangents_ = false;
  grf::MeshDraft made_;
};

// A reflection turns triangles inside out: the other winding order keeps their front.
void ShapeMaker::find_triangles() {
  const grf::Mesh& mesh = *shape_.mesh;
  const grf::Triangulation& triangulation = mesh.geometry.triangulation();
  const bool mirrors = shape_.to_world.determinant() < 0;
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    if ((*mesh.surface_of_face)[face] != shape_.surface) continue;
    for (std::size_t i = triangulation.first_of(face); i < triangulation.first_of(face + 1); ++i) {
      Corners corners = triangulation[i];
      if (mirrors) std::swap(corners[1], corners[2]);
      if (shape_.emission && !(area_vector(corners).length() > 0)) continue;
      triangles_.push_back(corners);
      is_smooth_ = is_smooth_ || (needs_.normals && !lacks_normal(corners));
    }
  }
}

bool ShapeMaker::lacks_normal(const Corners& corners) const {
  for (const std::uint32_t corner : corners) {
    if (!geometry_.normals.has(corner) || geometry_.normals[corner] == grf::Vec3f(0)) return true;
  }
  return false;
}

grf::Vec3d ShapeMaker::area_vector(const Corners& corners) const {
  const grf::Vec3d origin = position(corners[0]);
  return (position(corners[1]) - origin).cross(position(corners[2]) - origin);
}

std::uint32_t ShapeMaker::add_vertex(std::uint32_t vertex, const grf::Vec3f* normal) {
  const auto added = static_cast<std::uint32_t>(made_.positions.size());
  made_.positions.emplace_back(position(vertex));
  if (normal != nullptr) {
    made_.normals.set(added, *normal);
  } else if (is_smooth_) {
    grf::Vec3d turned(0);
    normals_to_world_.multDirMatrix(grf::Vec3d(geometry_.normals[vertex]), turned);
    made_.normals.set(added, grf::Vec3f(turned.normalized()));
  }
  if (needs_.vertex_colours) {
    const grf::Colour colour = geometry_.colours.has(vertex) ? geometry_.colours[vertex] : grf::Colour(1);
    made_.colours.set(added, *needs_.vertex_colours * colour);
  }
  if (needs_.uvs && !has_tangents_)
    made_.uvs.set(added, geometry_.uvs.has(vertex) ? geometry_.uvs[vertex] : grf::Vec2f(0));
  return added;
}

std::uint32_t ShapeMaker::shared_vertex(std::uint32_t vertex) {
  std::uint32_t& known = new_vertex_[vertex];
  if (known == NoVertex) known = add_vertex(vertex, nullptr);
  return known;
}

// The tangent without texture coordinates is the cross product of the object's y axis and the normal, as in
// our own renderer, here one for the whole triangle.
void ShapeMaker::add_tangents(const Corners& corners, const Corners& added) {
  const grf::Vec3d normal = area_vector(corners).normalized();
  grf::Vec3d axis(0);
  normals_to_world_.multDirMatrix(grf::Vec3d(0, 1, 0), axis);
  const grf::Vec3d along = axis.cross(normal).normalized();
  const grf::Vec3d across = normal.cross(along);
  const grf::Vec3d origin = position(corners[0]);
  for (std::size_t k = 0; k < 3; ++k) {
    const grf::Vec3d offset = position(corners[k]) - origin;
    made_.uvs.set(added[k], grf::Vec2f(grf::Vec2d(offset.dot(along), offset.dot(across))));
  }
}

void ShapeMaker::add_triangle(const Corners& corners) {
  const bool is_flat = is_smooth_ && lacks_normal(corners);
  const grf::Vec3f normal(is_flat ? area_vector(corners).normalized() : grf::Vec3d(0));
  Corners added = {};
  for (std::size_t k = 0; k < 3; ++k) {
    const bool is_shared = !is_flat && !has_tangents_;
    added[k] = is_shared ? shared_vertex(corners[k]) : add_vertex(corners[k], is_flat ? &normal : nullptr);
  }
  if (has_tangents_) add_tangents(corners, added);
  made_.add_face(added, 0);
}

grf::MeshDraft ShapeMaker::make() {
  has_tangents_ = needs_.tangents && geometry_.uvs.empty();
  for (const Corners& corners : triangles_) add_triangle(corners);
  return std::move(made_);
}

}  // namespace

grf::MeshDraft geometry_of(const RenderShape& shape, const GeometryNeeds& needs) {
  return ShapeMaker(shape, needs).make();
}

namespace {

/// Returns the texture coordinates of the centre of a texel, of a square image with (0,0) at its lower left.
grf::Vec2f texel_centre(std::size_t column, std::size_t row, std::size_t size) {
  const auto place = [size](std::size_t i) { return (double(i) + 0.5) / double(size); };
  return grf::Vec2f(grf::Vec2d(place(column), 1 - place(row)));
}

}  // namespace

// The fourth texel makes the interpolation linear, and may be outside of the range of colours.
image::Image bake_vertex_colours(grf::MeshDraft& mesh) {
  constexpr std::array<std::array<std::size_t, 2>, 4> Places = {{{0, 0}, {1, 0}, {0, 1}, {1, 1}}};
  // pbrt resamples images whose sides are no powers of two.
  std::size_t across = 1;
  while (across * across < mesh.face_count()) across *= 2;
  const std::size_t size = 2 * across;
  image::Image image{static_cast<int>(size), static_cast<int>(size), {}};
  image.pixels.resize(size * size);
  grf::MeshDraft separate;
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    std::array<grf::Colour, 4> colours;
    Corners added = {};
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t column = 2 * (face % across) + Places[k][0];
      const std::size_t row = 2 * (face / across) + Places[k][1];
      if (k < 3) {
        const std::uint32_t corner = mesh.face(face)[k];
        colours[k] = mesh.colours[corner];
        added[k] = static_cast<std::uint32_t>(separate.positions.size());
        separate.positions.push_back(mesh.positions[corner]);
        if (mesh.normals.has(corner)) separate.normals.set(added[k], mesh.normals[corner]);
        separate.uvs.set(added[k], texel_centre(column, row, size));
      }
      if (k == 2) colours[3] = colours[1] + colours[2] - colours[0];
      image.pixels[row * size + column] = colours[k];
    }
    separate.add_face(added, 0);
  }
  mesh = std::move(separate);
  return image;
}

grf::Colour mean_vertex_colour(const RenderShape& shape) {
  GeometryNeeds needs;
  needs.vertex_colours = grf::Colour(1);
  const grf::MeshDraft mesh = geometry_of(shape, needs);
  grf::Vec3d sum(0);
  double total = 0;
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    const double area = grf::doubled_area_vector(mesh.face(face), mesh.positions).length();
    for (const std::uint32_t corner : mesh.face(face)) sum += grf::Vec3d(mesh.colours[corner]) * (area / 3);
    total += area;
  }
  return total > 0 ? grf::Colour(sum / total) : grf::Colour(1);
}

}  // namespace convert
