#include "renderer/transport/bake_points.h"

#include <array>
#include <cassert>
#include <cmath>
#include <limits>

#include "grf/visit.h"

namespace transport {
namespace {

/// The angle at the first of three corners; 0 where they span no area.
float angle_at(const grf::Vec3d& corner, const grf::Vec3d& next, const grf::Vec3d& last) {
  const grf::Vec3d a = next - corner;
  const grf::Vec3d b = last - corner;
  const double area = a.cross(b).length();
  return area > 0 ? static_cast<float>(std::atan2(area, a.dot(b))) : 0;
}

/// The weights of the second and the third corner, near one of the corners.
Vec2f weights_near(std::uint32_t corner) {
  constexpr float Other = 1e-3F / 3;
  std::array<float, 3> weights = {Other, Other, Other};
  weights[corner] = 1 - 2 * Other;
  return {weights[1], weights[2]};
}

}  // namespace

CompileSettings without_instances(CompileSettings settings) {
  settings.most_copied_triangles = std::numeric_limits<std::size_t>::max();
  return settings;
}

BakePoints::BakePoints(const grf::Scene& scene, const CompiledScene& compiled) : compiled_(compiled) {
  list_vertices(scene);
  list_corners();
}

// In the order in which the compiled scene has them.
void BakePoints::list_vertices(const grf::Scene& scene) {
  std::uint32_t next = 0;
  grf::SceneVisitor visitor;
  visitor.mesh = [&](const grf::Mesh& mesh, const grf::Placement&, const grf::Block&) {
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) vertices_.push_back(next++);
  };
  visitor.mesh_light = [&](const grf::MeshLight& light, const grf::Placement&, const grf::Block&) {
    next += static_cast<std::uint32_t>(light.mesh->positions.size());
  };
  visitor.light = [&](const grf::AreaLight&, const grf::Placement&, const grf::Block&) { next += 4; };
  grf::visit(scene, visitor);
  assert(next + 1 == compiled_.geometry().meshes.front().positions.size());
}

void BakePoints::list_corners() {
  const TriangleMesh& mesh = compiled_.geometry().meshes.front();
  std::vector<std::array<float, 3>> angles(mesh.triangles.size());
  first_corner_.assign(mesh.positions.size() + 1, 0);
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const auto& corners = mesh.triangles[i].corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto position = [&](std::size_t turn) {
        return grf::Vec3d(mesh.positions[corners[(k + turn) % 3]]);
      };
      angles[i][k] = angle_at(position(0), position(1), position(2));
      if (angles[i][k] > 0) ++first_corner_[corners[k] + 1];
    }
  }
  for (std::size_t i = 1; i < first_corner_.size(); ++i) first_corner_[i] += first_corner_[i - 1];
  corners_.resize(first_corner_.back());
  std::vector<std::uint32_t> next(first_corner_.begin(), first_corner_.end() - 1);
  for (std::size_t i = 0; i < angles.size(); ++i) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      if (!(angles[i][k] > 0)) continue;
      corners_[next[mesh.triangles[i].corners[k]]++] = {static_cast<std::uint32_t>(i), k, angles[i][k]};
    }
  }
}

void BakePoints::points_at(std::size_t vertex, std::vector<Point>& points) const {
  points.clear();
  float sum = 0;
  for (const Corner& corner : corners_of(vertex)) {
    sum += corner.angle;
    points.push_back({compiled_.front_point({0, corner.triangle}, weights_near(corner.corner)), sum});
  }
  for (Point& point : points) point.share_end /= sum;
}

Vec3f BakePoints::normal_of(std::span<const Point> points) {
  Vec3f sum(0);
  float share_start = 0;
  for (const Point& point : points) {
    sum += point.point.shading_normal * (point.share_end - share_start);
    share_start = point.share_end;
  }
  return sum.length2() > 0 ? sum.normalized() : points.front().point.shading_normal;
}

}  // namespace transport
