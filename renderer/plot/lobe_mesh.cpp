#include "renderer/plot/lobe_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plot {
namespace {

using reflectance::Vec3f;

constexpr double LobeDecades = 5;

/// Returns directions in rings about the specular direction, the last ring at the horizon.
std::vector<Vec3f> directions_about_mirror(const Vec3f& u, const LobeGrid& grid) {
  const double radius = std::hypot(u.x, u.y);
  const Imath::V3d away = radius > 0 ? Imath::V3d(-u.x / radius, -u.y / radius, 0) : Imath::V3d(1, 0, 0);
  // At the horizon itself the rings would have no width.
  const double theta = std::min(std::atan2(radius, u.z), 89.0 * std::numbers::pi / 180);
  const Imath::V3d up(0, 0, 1);
  const Imath::V3d axis = std::sin(theta) * away + std::cos(theta) * up;
  const Imath::V3d towards_normal = -std::cos(theta) * away + std::sin(theta) * up;
  const Imath::V3d across(-away.y, away.x, 0);
  std::vector<Vec3f> directions;
  for (int ring = 0; ring <= grid.rings; ++ring) {
    for (int sector = 0; sector < grid.sectors; ++sector) {
      const double beta = 2 * std::numbers::pi * sector / grid.sectors;
      const double elevation = std::cos(beta) * towards_normal.z;
      const double horizon = std::atan2(axis.z, -elevation);
      const double fraction = static_cast<double>(ring) / grid.rings;
      const double alpha = horizon * fraction * fraction * (0.2 + 0.8 * fraction);
      const Imath::V3d side = std::cos(beta) * towards_normal + std::sin(beta) * across;
      Vec3f direction(std::cos(alpha) * axis + std::sin(alpha) * side);
      direction.z = std::max(direction.z, 1e-5F);
      directions.push_back(direction.normalized());
    }
  }
  return directions;
}

std::vector<std::uint32_t> triangles_of(const LobeGrid& grid) {
  std::vector<std::uint32_t> triangles;
  const auto vertex = [&](int ring, int sector) {
    return static_cast<std::uint32_t>(ring * grid.sectors + sector % grid.sectors);
  };
  for (int ring = 0; ring < grid.rings; ++ring) {
    for (int sector = 0; sector < grid.sectors; ++sector) {
      const std::uint32_t a = vertex(ring, sector);
      const std::uint32_t b = vertex(ring, sector + 1);
      const std::uint32_t c = vertex(ring + 1, sector + 1);
      const std::uint32_t d = vertex(ring + 1, sector);
      triangles.insert(triangles.end(), {a, c, d, a, b, c});
    }
  }
  return triangles;
}

void find_normals(LobeMesh& mesh, const LobeGrid& grid) {
  mesh.normals.assign(mesh.positions.size(), Vec3f(0));
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
    const Vec3f& a = mesh.positions[mesh.triangles[i]];
    const Vec3f& b = mesh.positions[mesh.triangles[i + 1]];
    const Vec3f& c = mesh.positions[mesh.triangles[i + 2]];
    const Vec3f normal = (b - a).cross(c - a);
    for (std::size_t k = 0; k < 3; ++k) mesh.normals[mesh.triangles[i + k]] += normal;
  }
  // The first ring is one point.
  const auto first_ring = mesh.normals.begin() + grid.sectors;
  Vec3f tip(0);
  std::for_each(mesh.normals.begin(), first_ring, [&](const Vec3f& normal) { tip += normal; });
  std::fill(mesh.normals.begin(), first_ring, tip);
  for (Vec3f& normal : mesh.normals) normal = normal.length2() > 0 ? normal.normalized() : Vec3f(0, 0, 1);
}

}  // namespace

double lobe_radius(double value, double peak, bool is_logarithmic) {
  const double radius = peak > 0 ? value / peak : 0;
  return is_logarithmic && radius > 0 ? std::max(0.0, 1 + std::log10(radius) / LobeDecades) : radius;
}

LobeMesh lobe_mesh(const reflectance::Brdf& brdf, const Vec3f& u, const LobeStyle& style,
                   const LobeGrid& grid, const std::function<bool()>& is_stopped) {
  LobeMesh mesh;
  mesh.directions = directions_about_mirror(u, grid);
  mesh.specular = channel_of(reflectance::specular_weight(brdf, u), style.channel);
  for (const Vec3f& v : mesh.directions) {
    if (is_stopped && is_stopped()) return {};
    const double value = channel_of(reflectance::evaluate(brdf, u, v), style.channel);
    mesh.values.push_back(static_cast<float>(style.with_cosine ? value * v.z : value));
    mesh.peak = std::max(mesh.peak, static_cast<double>(mesh.values.back()));
  }
  for (std::size_t i = 0; i < mesh.values.size(); ++i) {
    const double radius = lobe_radius(mesh.values[i], mesh.peak, style.is_logarithmic);
    mesh.positions.push_back(mesh.directions[i] * static_cast<float>(radius));
  }
  mesh.triangles = triangles_of(grid);
  find_normals(mesh, grid);
  return mesh;
}

}  // namespace plot
