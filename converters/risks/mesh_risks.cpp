#include "converters/risks/mesh_risks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <span>
#include <utility>

#include <boost/container_hash/hash.hpp>

#include "grf/topology.h"

namespace convert {
namespace {

using grf::Mesh;
using grf::Vec2d;
using grf::Vec3d;

constexpr double LeastUvArea = 1e-10;  // of an image whose sides are 1

bool has_area(const Mesh& mesh, std::uint32_t face) {
  const Vec3d doubled = grf::doubled_area_vector(*mesh.geometry, face, {});
  return grf::has_area(*mesh.geometry, face, doubled);
}

std::vector<std::uint32_t> faces_where(const Mesh& mesh, const std::function<bool(std::uint32_t)>& is_found) {
  std::vector<std::uint32_t> faces;
  for (std::uint32_t face = 0; face < mesh.face_count(); ++face) {
    if (is_found(face)) faces.push_back(face);
  }
  return faces;
}

double uv_area(const Mesh& mesh, std::uint32_t face) {
  const auto corners = mesh.face(face);
  const auto uv_of = [&](std::size_t k) {
    const std::uint32_t vertex = corners[k % corners.size()];
    return mesh.geometry->uvs.has(vertex) ? Vec2d(mesh.geometry->uvs[vertex]) : Vec2d(0);
  };
  double doubled = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) doubled += uv_of(k).cross(uv_of(k + 1));
  return std::abs(doubled) / 2;
}

/// The places of a face's corners, from the smallest on, so that rotations of a face are equal.
std::vector<std::uint32_t> rotated_places(const Mesh& mesh, std::uint32_t face,
                                          std::span<const std::uint32_t> places) {
  std::vector<std::uint32_t> corners;
  for (const std::uint32_t corner : mesh.face(face)) corners.push_back(places[corner]);
  // The first of equal smallest places may differ between rotations; such faces touch themselves and are
  // rare.
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

}  // namespace

std::vector<std::uint32_t> faces_without_area(const Mesh& mesh) {
  return faces_where(mesh, [&](std::uint32_t face) { return !has_area(mesh, face); });
}

std::vector<std::uint32_t> duplicate_faces(const Mesh& mesh) {
  const std::vector<std::uint32_t> places = grf::first_at_position(*mesh.geometry);
  // Sorted by a hash, faces with the same corners are neighbours.
  std::vector<std::pair<std::size_t, std::uint32_t>> faces;
  for (std::uint32_t face = 0; face < mesh.face_count(); ++face) {
    if (!has_area(mesh, face)) continue;
    const std::vector<std::uint32_t> corners = rotated_places(mesh, face, places);
    faces.emplace_back(boost::hash_range(corners.begin(), corners.end()), face);
  }
  std::sort(faces.begin(), faces.end());
  std::vector<std::uint32_t> duplicates;
  for (std::size_t i = 0, first = 0; i < faces.size(); ++i) {
    if (faces[i].first != faces[first].first) first = i;
    const bool is_duplicate = i > first && rotated_places(mesh, faces[i].second, places) ==
                                               rotated_places(mesh, faces[first].second, places);
    if (is_duplicate) duplicates.push_back(faces[i].second);
  }
  std::sort(duplicates.begin(), duplicates.end());
  return duplicates;
}

std::vector<std::uint32_t> faces_against_normals(const Mesh& mesh) {
  if (mesh.geometry->normals.empty()) return {};
  return faces_where(mesh, [&](std::uint32_t face) {
    const Vec3d doubled = grf::doubled_area_vector(*mesh.geometry, face, {});
    return grf::has_area(*mesh.geometry, face, doubled) &&
           grf::has_normals_behind(*mesh.geometry, face, doubled);
  });
}

std::vector<std::uint32_t> faces_without_uv_area(const Mesh& mesh) {
  const bool has_texture =
      std::any_of(mesh.surfaces.begin(), mesh.surfaces.end(),
                  [](const grf::Surface& surface) { return surface.texture.has_value(); });
  if (!has_texture) return {};
  return faces_where(mesh, [&](std::uint32_t face) {
    return mesh.surface(face).texture && has_area(mesh, face) && uv_area(mesh, face) < LeastUvArea;
  });
}

double winding_number(const grf::SharedGeometry& geometry, const Vec3d& point) {
  const grf::Triangulation& triangles = geometry.triangulation();
  double solid_angle = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    Vec3d corner[3];
    double distance[3];
    for (int k = 0; k < 3; ++k) {
      corner[k] = Vec3d(geometry->positions[triangles[i][static_cast<std::size_t>(k)]]) - point;
      distance[k] = corner[k].length();
    }
    const double numerator = corner[0].dot(corner[1].cross(corner[2]));
    const double denominator =
        distance[0] * distance[1] * distance[2] + corner[0].dot(corner[1]) * distance[2] +
        corner[1].dot(corner[2]) * distance[0] + corner[2].dot(corner[0]) * distance[1];
    solid_angle += 2 * std::atan2(numerator, denominator);
  }
  return solid_angle / (4 * std::numbers::pi);
}

}  // namespace convert
