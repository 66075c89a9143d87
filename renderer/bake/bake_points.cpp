#include "renderer/bake/bake_points.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>
#include <unordered_map>

#include "grf/visit.h"
#include "renderer/parallel/loops.h"
#include "renderer/transport/scene/used_vertices.h"

namespace bake {
namespace {

using grf::Vec2f;
using grf::Vec3f;
using transport::CompiledScene;
using transport::CompileSettings;
using transport::SurfacePoint;
using transport::UsedVertices;

/// Returns the angle at the first of three corners; 0 for a degenerate triangle.
float angle_at(const grf::Vec3d& corner, const grf::Vec3d& next, const grf::Vec3d& last) {
  const grf::Vec3d a = next - corner;
  const grf::Vec3d b = last - corner;
  const double area = a.cross(b).length();
  return area > 0 ? static_cast<float>(std::atan2(area, a.dot(b))) : 0;
}

/// Barycentric weights of the second and third corner, a fraction of the way from a corner to the centroid.
Vec2f weights_near(std::uint32_t corner, float way) {
  std::array<float, 3> weights = {way / 3, way / 3, way / 3};
  weights[corner] = 1 - 2 * way / 3;
  return {weights[1], weights[2]};
}

/// Steep and grazing rays to all sides: the grazing ones escape from below a sheet that hangs in the air.
constexpr float LowSine = 0.02F;
constexpr float D = std::numbers::sqrt2_v<float> / 2;
constexpr std::array WaysUp = {Vec3f(0, 0, 1),        Vec3f(1, 0, LowSine),  Vec3f(-1, 0, LowSine),
                               Vec3f(0, 1, LowSine),  Vec3f(0, -1, LowSine), Vec3f(D, D, LowSine),
                               Vec3f(-D, D, LowSine), Vec3f(D, -D, LowSine), Vec3f(-D, -D, LowSine)};

}  // namespace

CompileSettings without_instances(CompileSettings settings) {
  settings.most_copied_triangles = std::numeric_limits<std::size_t>::max();
  return settings;
}

BakePoints::BakePoints(const grf::Scene& scene, const CompiledScene& compiled, int threads)
    : compiled_(compiled) {
  list_vertices(scene);
  list_corners();
  parallel::run_with_threads(
      threads, [&] { parallel::for_each_index(vertices_.size(), [&](std::size_t i) { uncover(i); }); });
}

// In the compiled scene's order. Vertices that no face uses are not compiled: the compiled mesh's one vertex
// without faces stands for all of them.
void BakePoints::list_vertices(const grf::Scene& scene) {
  const auto unused = static_cast<std::uint32_t>(compiled_.geometry().meshes.front().positions.size() - 1);
  std::unordered_map<const grf::Mesh*, UsedVertices> known;
  const auto used_vertices = [&](const grf::Mesh& mesh) -> const UsedVertices& {
    const auto found = known.find(&mesh);
    return found != known.end() ? found->second : known.emplace(&mesh, mesh).first->second;
  };
  std::uint32_t next = 0;
  grf::SceneVisitor visitor;
  visitor.mesh = [&](const grf::Mesh& mesh, const grf::Placement&, const grf::Block&) {
    const UsedVertices& used = used_vertices(mesh);
    const std::size_t first = vertices_.size();
    vertices_.resize(first + mesh.geometry->positions.size(), unused);
    for (std::size_t i = 0; i < used.count(); ++i) vertices_[first + used[i]] = next++;
  };
  visitor.mesh_light = [&](const grf::MeshLight& light, const grf::Placement&, const grf::Block&) {
    next += static_cast<std::uint32_t>(used_vertices(*light.mesh).count());
  };
  visitor.light = [&](const grf::AreaLight&, const grf::Placement&, const grf::Block&) { next += 4; };
  grf::visit(scene, visitor);
  assert(next == unused);
}

void BakePoints::list_corners() {
  const transport::TriangleMesh& mesh = compiled_.geometry().meshes.front();
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
      corners_[next[mesh.triangles[i].corners[k]]++] = {static_cast<std::uint32_t>(i), k, angles[i][k],
                                                        Start};
    }
  }
}

SurfacePoint BakePoints::point_at(const Corner& corner) const {
  return compiled_.front_point({0, corner.triangle}, weights_near(corner.corner, corner.fraction));
}

bool BakePoints::is_covered(const Corner& corner) const {
  const SurfacePoint point = point_at(corner);
  const Vec3f& normal = point.geometric_normal;
  const transport::TriangleMesh& mesh = compiled_.geometry().meshes.front();
  const auto& corners = mesh.triangles[corner.triangle].corners;
  const Vec3f edge = mesh.positions[corners[1]] - mesh.positions[corners[0]];
  const float area = edge.cross(mesh.positions[corners[2]] - mesh.positions[corners[0]]).length();
  const float touching = 1e-3F * std::sqrt(area);
  const reflectance::Frame frame(normal);
  return std::all_of(WaysUp.begin(), WaysUp.end(), [&](const Vec3f& way) {
    const Vec3f direction = frame.to_world(way);
    const auto met = compiled_.intersect({point.origin_towards(direction), direction, point.id});
    if (!met) return false;
    if (direction.dot(met->geometric_normal) > 0) return true;
    return met->geometric_normal.dot(normal) < -0.5F &&
           (met->position - point.position).dot(normal) < touching;
  });
}

void BakePoints::uncover(std::size_t vertex) {
  const std::size_t first = first_corner_[vertices_[vertex]];
  const std::span<Corner> corners = std::span(corners_).subspan(first, corners_of(vertex).size());
  std::vector<bool> is_open;
  for (const Corner& corner : corners) is_open.push_back(!is_covered(corner));
  if (std::find(is_open.begin(), is_open.end(), true) == is_open.end()) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const float way = uncovered_fraction(corners[i]);
      is_open[i] = way > 0;
      if (way > 0) corners[i].fraction = way;
    }
  }
  if (std::find(is_open.begin(), is_open.end(), true) == is_open.end()) return;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (!is_open[i]) corners[i].angle = 0;
  }
}

/// Returns the fraction at which a covered point is unoccluded; 0 if there is none.
float BakePoints::uncovered_fraction(Corner corner) const {
  constexpr int Steps = 24;
  constexpr float OppositeEdge = 1.5F;
  for (int i = 1; i < Steps; ++i) {
    corner.fraction = OppositeEdge * static_cast<float>(i) / Steps;
    if (!is_covered(corner)) return corner.fraction;
  }
  return 0;
}

void BakePoints::points_at(std::size_t vertex, std::vector<Point>& points) const {
  points.clear();
  float sum = 0;
  for (const Corner& corner : corners_of(vertex)) {
    if (!(corner.angle > 0)) continue;
    sum += corner.angle;
    points.push_back({point_at(corner), sum});
  }
  for (Point& point : points) point.cumulative_fraction /= sum;
}

Vec3f BakePoints::normal_of(std::span<const Point> points) {
  Vec3f sum(0);
  float previous_fraction = 0;
  for (const Point& point : points) {
    sum += point.point.shading_normal * (point.cumulative_fraction - previous_fraction);
    previous_fraction = point.cumulative_fraction;
  }
  return sum.length2() > 0 ? sum.normalized() : points.front().point.shading_normal;
}

}  // namespace bake
