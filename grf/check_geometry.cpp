#include "grf/check_geometry.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include <ImathBoxAlgo.h>
#include <fmt/format.h>

#include "grf/summary.h"
#include "grf/vertex_tree.h"

namespace grf {
namespace {

// The tolerance of a light's plane, relative to the distance between light and vertex: closer points lie in
// it.
constexpr double LeastHeight = 1e-6;

bool lacks_uv(const Mesh& mesh, std::size_t face) {
  return std::ranges::any_of(mesh.face(face),
                             [&](std::uint32_t corner) { return !mesh.geometry->uvs.has(corner); });
}

std::string subject(const FaceDefects& faces) {
  if (faces.count == 1) return fmt::format("face {} has", faces.first);
  if (faces.meshes > 1) return fmt::format("{} faces of {} meshes have", faces.count, faces.meshes);
  return fmt::format("{} faces, the first is {}, have", faces.count, faces.first);
}

void add_face(FaceDefects& faces, std::size_t face) {
  if (faces.count++ == 0) faces.first = face;
  faces.meshes = 1;
}

void add_all(FaceDefects& faces, const FaceDefects& others) {
  if (faces.count == 0) faces.first = others.first;
  faces.count += others.count;
  faces.meshes += others.meshes;
}

std::string path_of(const SourceLocation& location) {
  return location.file ? location.file->path : std::string();
}

}  // namespace

void FaceCheck::add(const Mesh& mesh, const std::vector<bool>& reads_images, const SourceLocation& location,
                    Diagnostics& diagnostics) {
  Found found{location, {}, {}, {}};
  for (std::size_t i = 0; i < mesh.face_count(); ++i) {
    const Vec3d area = doubled_area_vector(*mesh.geometry, i, Matrix44d());
    if (!has_area(*mesh.geometry, i, area)) {
      add_face(found.flat, i);
    } else if (has_normals_behind(*mesh.geometry, i, area)) {
      add_face(found.turned, i);
    }
    if (reads_images[(*mesh.surface_of_face)[i]] && lacks_uv(mesh, i)) add_face(found.without_uv, i);
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

/// The half-space in front of a light, which its emission can reach.
class LightCheck::Front {
 public:
  Front(const Vec3d& point, const Vec3d& normal) : point_(point), normal_(normal) {}

  /// Returns the height of a position above the light's plane, in a unit of the light's own.
  double height(const Vec3d& position) const { return (position - point_).dot(normal_); }
  /// Returns a value above 0 in front of the light, and at most the height.
  double height_over_margin(const Vec3d& position) const {
    return height(position) - LeastHeight * (position - point_).length() * normal_.length();
  }

 private:
  Vec3d point_;
  Vec3d normal_;
};

/// The vertices of all bodies, searched by BVHs that are built on demand.
class LightCheck::World {
 public:
  explicit World(const std::vector<Body>& bodies) : bodies_(bodies) {
    std::vector<Box3d> boxes;
    for (const Body& body : bodies) {
      boxes.push_back(Imath::transform(body.mesh->geometry.vertices().bounds(), body.to_world));
    }
    tree_ = Bvh(boxes);
  }

  bool has_vertex_in(const Front& front) const {
    const auto height = [&](const Vec3d& corner) { return front.height(corner); };
    return tree_.highest([&](const Box3d& box) { return highest_at_corners(box, height); },
                         [&](std::size_t body) { return highest_vertex(front, bodies_[body]); }, 0, 0) > 0;
  }

 private:
  static double highest_vertex(const Front& front, const Body& body) {
    const auto height = [&](const Vec3d& corner) { return front.height(corner * body.to_world); };
    return body.mesh->geometry.vertices().highest(
        [&](const Box3d& box) { return highest_at_corners(box, height); },
        [&](const Vec3d& vertex) { return front.height_over_margin(vertex * body.to_world); }, 0, 0);
  }

  const std::vector<Body>& bodies_;
  Bvh tree_;  ///< over the bounds of the bodies
};

void LightCheck::add(const Mesh& mesh, const Placement& placement) {
  if (mesh.face_count() > 0) bodies_.push_back({&mesh, placement.to_world});
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
  if (lights_.empty()) return;
  // A file that has only lights is meant to be included in scenes.
  const bool is_part = bodies_.empty();
  const World world(bodies_);
  for (const Light& light : lights_) {
    const bool has_area = light.mesh == nullptr ? light.normal.length() > 0 : light.mesh->face_count() > 0;
    if (!has_area) {
      diagnostics.warning(light.location, "a light without area");
    } else if (!is_part && !faces_something(light, world)) {
      diagnostics.warning(light.location, "nothing is in front of this light, on the side that emits");
    }
  }
}

bool LightCheck::faces_something(const Light& light, const World& world) {
  if (light.mesh == nullptr) return world.has_vertex_in(Front(light.point, light.normal));
  const double side = light.to_world.determinant() < 0 ? -1 : 1;
  for (std::size_t i = 0; i < light.mesh->face_count(); ++i) {
    const Vec3d point = Vec3d(light.mesh->geometry->positions[light.mesh->face(i).front()]) * light.to_world;
    const Front front(point, doubled_area_vector(*light.mesh->geometry, i, light.to_world) * side);
    if (world.has_vertex_in(front)) return true;
  }
  return false;
}

}  // namespace grf
