#include "editor/view/mesh_geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "grf/summary.h"
#include "grf/topology.h"

namespace editor {
namespace {

using grf::Vec3d;
using grf::Vec3f;

constexpr std::size_t TrianglesPerBox = 128;

Imath::V4f with_w(const Vec3f& v, float w) { return {v.x, v.y, v.z, w}; }

grf::Colour total(const grf::Irradiance& irradiance) {
  if (const auto* colour = std::get_if<grf::Colour>(&irradiance)) return *colour;
  grf::Colour sum(0);
  for (const auto& ray : std::get<std::vector<grf::DirectionalIrradiance>>(irradiance)) sum += ray.irradiance;
  return sum;
}

void copy_vertices(const grf::Mesh& mesh, TriangleArrays& arrays) {
  const grf::Geometry& geometry = *mesh.geometry;
  const grf::VertexIrradiance& irradiance = *mesh.irradiance;
  const std::size_t count = geometry.positions.size();
  arrays.positions = geometry.positions;
  arrays.normals.assign(count, Imath::V4f(0));
  if (!geometry.colours.empty()) arrays.colours.assign(count, Imath::V4f(1));
  if (!irradiance.empty()) arrays.irradiance.assign(count, Imath::V4f(0));
  if (!geometry.uvs.empty()) arrays.uvs.assign(count, grf::Vec2f(0));
  for (std::size_t i = 0; i < count; ++i) {
    if (geometry.normals.has(i)) arrays.normals[i] = with_w(geometry.normals[i].normalized(), 1);
    if (geometry.colours.has(i)) arrays.colours[i] = with_w(geometry.colours[i], 1);
    if (irradiance.has(i)) arrays.irradiance[i] = with_w(total(irradiance[i]), 1);
    if (geometry.uvs.has(i)) arrays.uvs[i] = geometry.uvs[i];
  }
}

/// Slab test of a line and a box between these distances; correct with infinities for axis-aligned
/// directions.
bool meets(const grf::Box3f& box, const Vec3d& origin, const Vec3d& inverse, double nearest,
           double farthest) {
  for (int i = 0; i < 3; ++i) {
    double enter = (box.min[i] - origin[i]) * inverse[i];
    double leave = (box.max[i] - origin[i]) * inverse[i];
    if (enter > leave) std::swap(enter, leave);
    // A comparison with NaN, for a ray in the plane of a side, is false and keeps the box.
    if (enter > nearest) nearest = enter;
    if (leave < farthest) farthest = leave;
  }
  // Slightly enlarged, for the rounding of flat boxes.
  return nearest <= farthest + 1e-9 * std::abs(farthest) + 1e-12;
}

/// Möller and Trumbore (1997), "Fast, minimum storage ray/triangle intersection".
std::optional<double> intersect_triangle(const ViewRay& ray, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const Vec3d edge1 = b - a;
  const Vec3d edge2 = c - a;
  const Vec3d p = ray.direction.cross(edge2);
  const double determinant = edge1.dot(p);
  if (determinant == 0) return std::nullopt;
  const Vec3d from_a = ray.origin - a;
  const double u = from_a.dot(p) / determinant;
  if (!(u >= 0 && u <= 1)) return std::nullopt;
  const Vec3d q = from_a.cross(edge1);
  const double v = ray.direction.dot(q) / determinant;
  if (!(v >= 0 && u + v <= 1)) return std::nullopt;
  return edge2.dot(q) / determinant;
}

}  // namespace

MeshGeometry::MeshGeometry(const grf::Mesh& mesh) : geometry_(mesh.geometry) {
  copy_vertices(mesh, arrays_);
  cut_faces();
  enclose_triangles();
}

void MeshGeometry::cut_faces() {
  const std::size_t faces = geometry_->face_count();
  const grf::Triangulation& triangles = geometry_.triangulation();
  arrays_.triangles.reserve(triangles.size());
  arrays_.face_of_triangle.reserve(triangles.size());
  centres_.reserve(faces);
  normals_.reserve(faces);
  for (std::size_t i = 0; i < faces; ++i) {
    const auto face = geometry_->face(i);
    Vec3d sum(0);
    for (const std::uint32_t corner : face) sum += Vec3d(geometry_->positions[corner]);
    centres_.emplace_back(sum / static_cast<double>(face.size()));
    normals_.emplace_back(grf::doubled_area_vector(*geometry_, i, {}).normalized());
    for (std::size_t k = triangles.first_of(i); k < triangles.first_of(i + 1); ++k) {
      arrays_.triangles.push_back(triangles[k]);
      arrays_.face_of_triangle.push_back(static_cast<std::uint32_t>(i));
    }
  }
}

std::vector<MeshGeometry::Edge> MeshGeometry::edges(const FaceSelection::Faces& hidden) const {
  std::vector<Edge> edges;
  const auto is_hidden = [&hidden](const grf::HalfEdge& edge) { return hidden[edge.face]; };
  grf::for_each_edge(grf::half_edges_of(*geometry_, {}), [&](std::span<const grf::HalfEdge> of_faces) {
    if (!hidden.empty() && std::ranges::all_of(of_faces, is_hidden)) return;
    const std::uint64_t ends = of_faces.front().places;
    edges.push_back({static_cast<std::uint32_t>(ends >> 32U), static_cast<std::uint32_t>(ends)});
  });
  return edges;
}

void MeshGeometry::enclose_triangles() {
  const auto& triangles = arrays_.triangles;
  boxes_.resize((triangles.size() + TrianglesPerBox - 1) / TrianglesPerBox);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (const std::uint32_t corner : triangles[i])
      boxes_[i / TrianglesPerBox].extendBy(arrays_.positions[corner]);
  }
  for (const grf::Box3f& box : boxes_) bounds_.extendBy(box);
}

std::optional<MeshHit> MeshGeometry::intersect(const ViewRay& ray, const FaceSelection::Faces& hidden) const {
  const Vec3d inverse(1 / ray.direction.x, 1 / ray.direction.y, 1 / ray.direction.z);
  MeshHit nearest{std::numeric_limits<double>::infinity(), 0};
  for (std::size_t box = 0; box < boxes_.size(); ++box) {
    if (!meets(boxes_[box], ray.origin, inverse, ray.nearest, nearest.distance)) continue;
    const std::size_t end = std::min((box + 1) * TrianglesPerBox, arrays_.triangles.size());
    for (std::size_t i = box * TrianglesPerBox; i < end; ++i) {
      if (!hidden.empty() && hidden[arrays_.face_of_triangle[i]]) continue;
      const auto& [a, b, c] = arrays_.triangles[i];
      const auto distance = intersect_triangle(ray, Vec3d(arrays_.positions[a]), Vec3d(arrays_.positions[b]),
                                               Vec3d(arrays_.positions[c]));
      if (distance && *distance > ray.nearest && *distance < nearest.distance) {
        nearest = {*distance, static_cast<std::uint32_t>(i)};
      }
    }
  }
  if (nearest.distance == std::numeric_limits<double>::infinity()) return std::nullopt;
  return nearest;
}

}  // namespace editor
