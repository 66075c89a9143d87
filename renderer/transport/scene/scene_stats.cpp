#include "renderer/transport/scene/scene_stats.h"

#include <algorithm>
#include <cmath>

#include "renderer/transport/scene/mesh_builder.h"

namespace transport {
namespace {

using grf::Box3d;
using grf::Vec3d;

/// Copying a mesh of a few triangles takes less memory than an instance.
constexpr std::size_t FewTriangles = 8;

double largest_component(const Vec3d& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

Vec3d origin_of(const Box3d& bounds) {
  // Below this distance, a shift would gain at most 4 bits.
  constexpr double FarAway = 16;
  if (bounds.isEmpty() || largest_component(bounds.center()) <= FarAway * largest_component(bounds.size())) {
    return Vec3d(0);
  }
  return Vec3d(grf::Vec3f(bounds.center()));
}

struct Places {
  std::size_t count = 0;
  grf::Box3f box;
};

}  // namespace

Box3d transformed(const grf::Box3f& box, const grf::Matrix44d& map) {
  Box3d result;
  for (int i = 0; i < 8 && !box.isEmpty(); ++i) {
    const auto corner = [&](int axis) {
      return double((i >> axis & 1) != 0 ? box.max[axis] : box.min[axis]);
    };
    result.extendBy(Vec3d(corner(0), corner(1), corner(2)) * map);
  }
  return result;
}

SceneStats::SceneStats(const grf::Scene& scene, std::size_t most_copied_triangles) {
  std::unordered_map<const grf::Mesh*, Places> places;
  Box3d bounds;
  const auto add = [&](const grf::Mesh& mesh, const grf::Placement& placement) {
    const auto [entry, is_new] = places.try_emplace(&mesh);
    if (is_new) {
      const UsedVertices& used = used_vertices.emplace(&mesh, mesh).first->second;
      for (std::size_t i = 0; i < used.count(); ++i)
        entry->second.box.extendBy(mesh.geometry->positions[used[i]]);
    }
    ++entry->second.count;
    bounds.extendBy(transformed(entry->second.box, placement.to_world));
  };
  grf::SceneVisitor visitor;
  visitor.mesh = [&](const grf::Mesh& mesh, const grf::Placement& placement, const grf::Block&) {
    add(mesh, placement);
  };
  visitor.mesh_light = [&](const grf::MeshLight& light, const grf::Placement& placement, const grf::Block&) {
    add(*light.mesh, placement);
  };
  visitor.light = [&](const grf::AreaLight& light, const grf::Placement& placement, const grf::Block&) {
    const Vec3d corner(light.corner), edge1(light.edge1), edge2(light.edge2);
    for (const Vec3d& vertex : {corner, corner + edge1, corner + edge2, corner + edge1 + edge2}) {
      bounds.extendBy(vertex * placement.to_world);
    }
    triangles += 2;
    vertices += 4;
    ++surfaces;
  };
  grf::visit(scene, visitor);
  origin = origin_of(bounds);
  for (const auto& [mesh, place] : places) {
    const std::size_t count = mesh->geometry->triangle_count();
    const bool is_worth_it =
        place.count > 1 && count > FewTriangles && count * place.count > most_copied_triangles;
    if (is_worth_it) instanced.emplace(mesh, place.box);
    if (is_worth_it) instances += place.count;
    const std::size_t copies = is_worth_it ? 1 : place.count;
    triangles += count * copies;
    vertices += vertices_of(*mesh).count() * copies;
    surfaces += mesh->surfaces.size() * place.count;
  }
}

}  // namespace transport
