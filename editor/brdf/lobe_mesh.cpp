#include "editor/brdf/lobe_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace editor {
namespace {

using reflectance::Vec3f;

constexpr int Rings = 72;     // about the specular direction
constexpr int Sectors = 128;  // around it
constexpr double LobeDecades = 5;

/// Directions in rings about the specular direction, the last ring at the horizon.
std::vector<Vec3f> directions_about(double degrees) {
  // At the horizon itself the rings would have no width.
  const double theta = std::min(degrees, 89.0) * std::numbers::pi / 180;
  const Imath::V3d axis(std::sin(theta), 0, std::cos(theta));
  const Imath::V3d towards_normal(-std::cos(theta), 0, std::sin(theta));
  const Imath::V3d across(0, 1, 0);
  std::vector<Vec3f> directions;
  for (int ring = 0; ring <= Rings; ++ring) {
    for (int sector = 0; sector < Sectors; ++sector) {
      const double beta = 2 * std::numbers::pi * sector / Sectors;
      const double elevation = std::cos(beta) * towards_normal.z;
      const double horizon = std::atan2(axis.z, -elevation);
      const double fraction = static_cast<double>(ring) / Rings;
      const double alpha = horizon * fraction * fraction * (0.2 + 0.8 * fraction);
      const Imath::V3d side = std::cos(beta) * towards_normal + std::sin(beta) * across;
      Vec3f direction(std::cos(alpha) * axis + std::sin(alpha) * side);
      direction.z = std::max(direction.z, 1e-5F);
      directions.push_back(direction.normalized());
    }
  }
  return directions;
}

std::vector<std::uint32_t> grid_triangles() {
  std::vector<std::uint32_t> triangles;
  const auto vertex = [](int ring, int sector) {
    return static_cast<std::uint32_t>(ring * Sectors + sector % Sectors);
  };
  for (int ring = 0; ring < Rings; ++ring) {
    for (int sector = 0; sector < Sectors; ++sector) {
      const std::uint32_t a = vertex(ring, sector);
      const std::uint32_t b = vertex(ring, sector + 1);
      const std::uint32_t c = vertex(ring + 1, sector + 1);
      const std::uint32_t d = vertex(ring + 1, sector);
      triangles.insert(triangles.end(), {a, c, d, a, b, c});
    }
  }
  return triangles;
}

void find_normals(LobeMesh& mesh) {
  mesh.normals.assign(mesh.positions.size(), Vec3f(0));
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
    const Vec3f& a = mesh.positions[mesh.triangles[i]];
    const Vec3f& b = mesh.positions[mesh.triangles[i + 1]];
    const Vec3f& c = mesh.positions[mesh.triangles[i + 2]];
    const Vec3f normal = (b - a).cross(c - a);
    for (std::size_t k = 0; k < 3; ++k) mesh.normals[mesh.triangles[i + k]] += normal;
  }
  // The first ring is one point.
  Vec3f tip(0);
  for (int sector = 0; sector < Sectors; ++sector) tip += mesh.normals[static_cast<std::size_t>(sector)];
  for (int sector = 0; sector < Sectors; ++sector) mesh.normals[static_cast<std::size_t>(sector)] = tip;
  for (Vec3f& normal : mesh.normals) normal = normal.length2() > 0 ? normal.normalized() : Vec3f(0, 0, 1);
}

}  // namespace

LobeMesh lobe_mesh(const reflectance::Brdf& brdf, double view, bool with_cosine, bool is_logarithmic,
                   const StopFlag& stop) {
  LobeMesh mesh;
  mesh.view = view;
  mesh.directions = directions_about(view);
  const Vec3f u = plot::direction_at(-view);
  mesh.specular = plot::channel_of(reflectance::specular_weight(brdf, u), plot::Channel::Luminance);
  for (const Vec3f& v : mesh.directions) {
    if (stop.is_set()) return {};
    const double value = plot::channel_of(reflectance::evaluate(brdf, u, v), plot::Channel::Luminance);
    mesh.values.push_back(static_cast<float>(with_cosine ? value * v.z : value));
    mesh.peak = std::max(mesh.peak, static_cast<double>(mesh.values.back()));
  }
  for (std::size_t i = 0; i < mesh.values.size(); ++i) {
    double length = mesh.peak > 0 ? mesh.values[i] / mesh.peak : 0;
    if (is_logarithmic && length > 0) length = std::max(0.0, 1 + std::log10(length) / LobeDecades);
    mesh.positions.push_back(mesh.directions[i] * static_cast<float>(length));
  }
  mesh.triangles = grid_triangles();
  find_normals(mesh);
  return mesh;
}

}  // namespace editor
