#include "grf/check_geometry.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include <fmt/format.h>

#include "grf/summary.h"

namespace grf {
namespace {

// Of what a face's longest edge squared would give: less is rounding.
constexpr double LeastArea = 1e-7;
// Of the distance between a light and a vertex: what is nearer to the light's plane lies in it.
constexpr double LeastHeight = 1e-6;

double longest_edge2(const Mesh& mesh, std::size_t face) {
  const auto corners = mesh.face(face);
  double longest = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec3d a(mesh.positions[corners[k]]);
    const Vec3d b(mesh.positions[corners[(k + 1) % corners.size()]]);
    longest = std::max(longest, (a - b).length2());
  }
  return longest;
}

bool has_normals_behind(const Mesh& mesh, std::size_t face, const Vec3d& area) {
  const auto corners = mesh.face(face);
  return std::all_of(corners.begin(), corners.end(), [&](std::uint32_t corner) {
    return mesh.normals.has(corner) && Vec3d(mesh.normals[corner]).dot(area) < 0;
  });
}

bool lacks_uv(const Mesh& mesh, std::size_t face) {
  const auto corners = mesh.face(face);
  return mesh.surface(face).texture && std::any_of(corners.begin(), corners.end(), [&](std::uint32_t corner) {
           return !mesh.uvs.has(corner);
         });
}

std::string subject(const Offenders& faces) {
  if (faces.count == 1) return fmt::format("face {} has", faces.first);
  if (faces.meshes > 1) return fmt::format("{} faces of {} meshes have", faces.count, faces.meshes);
  return fmt::format("{} faces, the first is {}, have", faces.count, faces.first);
}

void add_face(Offenders& faces, std::size_t face) {
  if (faces.count++ == 0) faces.first = face;
  faces.meshes = 1;
}

void add_all(Offenders& faces, const Offenders& others) {
  if (faces.count == 0) faces.first = others.first;
  faces.count += others.count;
  faces.meshes += others.meshes;
}

std::string path_of(const SourceLocation& location) {
  return location.file ? location.file->path : std::string();
}

}  // namespace

void FaceCheck::add(const Mesh& mesh, const SourceLocation& location, Diagnostics& diagnostics) {
  Found found{location, {}, {}, {}};
  for (std::size_t i = 0; i < mesh.face_count(); ++i) {
    const Vec3d area = doubled_area_vector(mesh, i, Matrix44d());
    if (area.length() <= LeastArea * longest_edge2(mesh, i)) {
      add_face(found.flat, i);
    } else if (has_normals_behind(mesh, i, area)) {
      add_face(found.turned, i);
    }
    if (lacks_uv(mesh, i)) add_face(found.without_uv, i);
  }
  if (location.line > 0) return report(found, diagnostics);
  const auto of_file = std::find_if(without_lines_.begin(), without_lines_.end(), [&](const Found& other) {
    return path_of(other.location) == path_of(location);
  });
  if (of_file == without_lines_.end()) return without_lines_.push_back(found);
  add_all(of_file->flat, found.flat);
  add_all(of_file->turned, found.turned);
  add_all(of_file->without_uv, found.without_uv);
}

void FaceCheck::report(Diagnostics& diagnostics) const {
  for (const Found& found : without_lines_) report(found, diagnostics);
}

void FaceCheck::report(const Found& found, Diagnostics& diagnostics) {
  if (found.flat.count > 0) {
    diagnostics.warning(found.location, subject(found.flat) + " no area");
  }
  if (found.turned.count > 0) {
    diagnostics.warning(found.location, subject(found.turned) + " normals that point away from the front");
  }
  if (found.without_uv.count > 0) {
    diagnostics.warning(found.location,
                        subject(found.without_uv) + " a texture and corners without uv: it is (0, 0) there");
  }
}

void LightCheck::add(const Mesh& mesh, const Placement& placement) {
  if (mesh.face_count() == 0) return;
  Box3f box;
  for (const Vec3f& position : mesh.positions) box.extendBy(position);
  Body body{&mesh, placement.to_world, {}};
  for (std::size_t i = 0; i < body.corners.size(); ++i) {
    const Vec3d corner((i & 1U) != 0 ? box.max.x : box.min.x, (i & 2U) != 0 ? box.max.y : box.min.y,
                       (i & 4U) != 0 ? box.max.z : box.min.z);
    body.corners[i] = corner * placement.to_world;
  }
  bodies_.push_back(body);
}

void LightCheck::add_light(const AreaLight& light, const Placement& placement, const Block& block) {
  Vec3d edge1;
  Vec3d edge2;
  placement.to_world.multDirMatrix(Vec3d(light.edge1), edge1);
  placement.to_world.multDirMatrix(Vec3d(light.edge2), edge2);
  const double side = placement.to_world.determinant() < 0 ? -1 : 1;
  const Vec3d centre = Vec3d(light.corner) * placement.to_world + (edge1 + edge2) / 2;
  lights_.push_back({nullptr, placement.to_world, centre, edge1.cross(edge2) * side, block.location});
}

void LightCheck::add_light(const MeshLight& light, const Placement& placement, const Block& block) {
  lights_.push_back({&*light.mesh, placement.to_world, {}, {}, block.location});
}

void LightCheck::report(Diagnostics& diagnostics) const {
  // A file of lights alone is a part of scenes.
  const bool is_part = bodies_.empty();
  for (const Light& light : lights_) {
    const bool has_area = light.mesh == nullptr ? light.normal.length() > 0 : light.mesh->face_count() > 0;
    if (!has_area) {
      diagnostics.warning(light.location, "a light without area");
    } else if (!is_part && !faces_something(light)) {
      diagnostics.warning(light.location, "nothing is in front of this light, on the side that emits");
    }
  }
}

bool LightCheck::faces_something(const Light& light) const {
  if (light.mesh == nullptr) return faces_something(light.point, light.normal);
  const double side = light.to_world.determinant() < 0 ? -1 : 1;
  for (std::size_t i = 0; i < light.mesh->face_count(); ++i) {
    const Vec3d point = Vec3d(light.mesh->positions[light.mesh->face(i).front()]) * light.to_world;
    if (faces_something(point, doubled_area_vector(*light.mesh, i, light.to_world) * side)) return true;
  }
  return false;
}

bool LightCheck::faces_something(const Vec3d& point, const Vec3d& normal) const {
  const auto is_in_front = [&](const Vec3d& position) {
    const Vec3d d = position - point;
    return d.dot(normal) > LeastHeight * d.length() * normal.length();
  };
  return std::any_of(bodies_.begin(), bodies_.end(), [&](const Body& body) {
    const auto front_corners = std::count_if(body.corners.begin(), body.corners.end(), is_in_front);
    if (front_corners == 0) return false;
    if (front_corners == static_cast<std::ptrdiff_t>(body.corners.size())) return true;
    const std::vector<Vec3f>& positions = body.mesh->positions;
    return std::any_of(positions.begin(), positions.end(),
                       [&](const Vec3f& position) { return is_in_front(Vec3d(position) * body.to_world); });
  });
}

}  // namespace grf
