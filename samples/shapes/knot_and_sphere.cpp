#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "samples/shapes/shape.h"

namespace shape {
namespace {

using grf::Mesh;
using grf::MeshDraft;

constexpr double FullTurn = 2 * std::numbers::pi;

/// A bump of height 1 and period 2 pi, narrower than a sine's.
double tube_ridge(double angle) { return std::exp(1.8 * (std::cos(angle) - 1)); }

/// The tube's radius. Whole multiples of both angles, so that it closes.
double tube_radius(double along, double around) {
  const double ridges = 0.15 * tube_ridge(5 * around + 4 * along);
  const double waist = 0.08 * std::cos(7 * along);
  const double bumps = 0.025 * std::sin(23 * along) * std::sin(4 * around - 5 * along);
  const double grain = 0.006 * std::sin(47 * along + 3 * around) * std::cos(8 * around - 17 * along);
  return 0.43 + ridges + waist + bumps + grain;
}

/// The knot's curve winds twice about a torus' axis and three times about its core: the normal of the torus
/// is perpendicular to it everywhere, and turns evenly.
V3d knot_at(double along, double around) {
  const double turn = 2 * along;
  const double roll = 3 * along;
  const V3d outwards(std::cos(turn), std::sin(turn), 0);
  const V3d tangential(-std::sin(turn), std::cos(turn), 0);
  const V3d normal = outwards * std::cos(roll) + V3d(0, 0, std::sin(roll));
  const V3d centre = outwards * 2 + normal;
  const double distance = 2 + std::cos(roll);
  const V3d tangent =
      tangential * (2 * distance) + (V3d(0, 0, std::cos(roll)) - outwards * std::sin(roll)) * 3;
  const V3d across = tangent.normalized().cross(normal);
  return centre + (normal * std::cos(around) + across * std::sin(around)) * tube_radius(along, around);
}

V3d knot_normal_at(double along, double around) {
  constexpr double Step = 1e-5;
  const V3d by_along = knot_at(along + Step, around) - knot_at(along - Step, around);
  const V3d by_around = knot_at(along, around + Step) - knot_at(along, around - Step);
  return by_around.cross(by_along).normalized();
}

struct TubeGrid {
  std::uint32_t along;
  std::uint32_t around;
};

/// The grid of about so many quads that comes nearest to it, with quads that are about square.
TubeGrid grid_of(double quads, double length_over_girth) {
  const double square = std::sqrt(quads / length_over_girth);
  TubeGrid best = {};
  double smallest_miss = quads;
  const auto first = std::max(3U, static_cast<std::uint32_t>(0.85 * square));
  for (std::uint32_t around = first; around <= std::max(3.0, 1.15 * square) + 1; ++around) {
    const auto along = std::max(3U, static_cast<std::uint32_t>(std::lround(quads / around)));
    const double miss = std::abs(static_cast<double>(along) * around - quads);
    if (miss < smallest_miss) {
      smallest_miss = miss;
      best = {along, around};
    }
  }
  return best;
}

void add_quads(MeshDraft& mesh, const TubeGrid& grid) {
  for (std::uint32_t i = 0; i < grid.along; ++i) {
    const std::uint32_t row = i * grid.around;
    const std::uint32_t next = (i + 1) % grid.along * grid.around;
    for (std::uint32_t k = 0; k < grid.around; ++k) {
      const std::uint32_t beside = (k + 1) % grid.around;
      mesh.add_face(std::array{row + k, row + beside, next + beside}, 0);
      mesh.add_face(std::array{row + k, next + beside, next + k}, 0);
    }
  }
}

/// Circles of vertices between two poles.
void add_circles(MeshDraft& mesh, std::uint32_t rings, std::uint32_t segments) {
  const auto add = [&](const V3d& direction) {
    mesh.normals.set(mesh.positions.size(), rounded(direction, 1e4));
    mesh.positions.push_back(rounded(direction + V3d(0, 1, 0), 1e5));
  };
  add({0, 1, 0});
  for (std::uint32_t i = 1; i < rings; ++i) {
    const double theta = std::numbers::pi * i / rings;
    for (std::uint32_t k = 0; k < segments; ++k) {
      const double phi = FullTurn * k / segments;
      add({std::sin(theta) * std::cos(phi), std::cos(theta), -std::sin(theta) * std::sin(phi)});
    }
  }
  add({0, -1, 0});
}

}  // namespace

Mesh knot(int triangles) {
  const TubeGrid grid = grid_of(triangles / 2.0, 8);
  std::vector<V3d> positions;
  MeshDraft mesh;
  for (std::uint32_t i = 0; i < grid.along * grid.around; ++i) {
    const double along = FullTurn * (i / grid.around) / grid.along;
    const double around = FullTurn * (i % grid.around) / grid.around;
    positions.push_back(knot_at(along, around));
    mesh.normals.set(i, rounded(knot_normal_at(along, around), 1e4));
  }
  const Fitting fit(positions);
  for (const V3d& position : positions) mesh.positions.push_back(rounded(fit(position), 1e5));
  add_quads(mesh, grid);
  return mesh;
}

Mesh sphere(int triangles) {
  // A ring at a pole has triangles, and any other has quads: 2 segments (rings - 1) triangles.
  const double rings_wanted = 0.5 + std::sqrt(0.25 + triangles / 4.0);
  const auto rings = static_cast<std::uint32_t>(std::lround(rings_wanted));
  const std::uint32_t segments = 2 * rings;
  MeshDraft mesh;
  add_circles(mesh, rings, segments);
  const auto bottom = static_cast<std::uint32_t>(mesh.positions.size() - 1);
  for (std::uint32_t k = 0; k < segments; ++k) {
    const std::uint32_t beside = (k + 1) % segments;
    mesh.add_face(std::array{0U, 1 + k, 1 + beside}, 0);
    for (std::uint32_t i = 0; i + 2 < rings; ++i) {
      const std::uint32_t row = 1 + i * segments;
      const std::uint32_t next = row + segments;
      mesh.add_face(std::array{row + k, next + k, next + beside}, 0);
      mesh.add_face(std::array{row + k, next + beside, row + beside}, 0);
    }
    const std::uint32_t last = 1 + (rings - 2) * segments;
    mesh.add_face(std::array{last + k, bottom, last + beside}, 0);
  }
  return mesh;
}

}  // namespace shape
