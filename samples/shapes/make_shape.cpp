// Writes a closed mesh with smooth normals as GRF, made by formula and the same on every machine: a subject
// for measurements that need a chosen number of triangles. It stands on y = 0 about the y axis, and its
// longest side is 2.
//   knot    a trefoil whose tube has spiralling ridges and bumps: folds, shadows on itself, detail of all
//   sizes sphere  circles of latitude dragon  a twisted serpent with legs, wings, spikes and scales; 20,000
//   triangles show its shape, 200,000 its scales jug     a vessel of some thickness with a lip and a handle
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "grf/write.h"
#include "samples/shapes/shape.h"

namespace {

using grf::Mesh;
using grf::MeshDraft;
using Imath::V3d;
using shape::Fitting;
using shape::rounded;

constexpr double TwoPi = 2 * std::numbers::pi;

/// A bump of height 1 and period 2 pi, narrower than a sine's.
double ridge(double angle) { return std::exp(1.8 * (std::cos(angle) - 1)); }

/// The tube's radius. Whole multiples of both angles, so that it closes.
double tube_radius(double along, double around) {
  const double ridges = 0.15 * ridge(5 * around + 4 * along);
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

struct Grid {
  std::uint32_t along;
  std::uint32_t around;
};

/// The grid of about so many quads that comes nearest to it, with quads that are about square.
Grid grid_of(double quads, double length_over_girth) {
  const double square = std::sqrt(quads / length_over_girth);
  Grid best = {};
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

void add_quads(MeshDraft& mesh, const Grid& grid) {
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

Mesh knot(int triangles) {
  const Grid grid = grid_of(triangles / 2.0, 8);
  std::vector<V3d> positions;
  MeshDraft mesh;
  for (std::uint32_t i = 0; i < grid.along * grid.around; ++i) {
    const double along = TwoPi * (i / grid.around) / grid.along;
    const double around = TwoPi * (i % grid.around) / grid.around;
    positions.push_back(knot_at(along, around));
    mesh.normals.set(i, rounded(knot_normal_at(along, around), 1e4));
  }
  const Fitting fit(positions);
  for (const V3d& position : positions) mesh.positions.push_back(rounded(fit(position), 1e5));
  add_quads(mesh, grid);
  return mesh;
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
      const double phi = TwoPi * k / segments;
      add({std::sin(theta) * std::cos(phi), std::cos(theta), -std::sin(theta) * std::sin(phi)});
    }
  }
  add({0, -1, 0});
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

struct Maker {
  std::string_view name;
  Mesh (*make)(int triangles);
};

constexpr std::array<Maker, 4> Makers = {
    {{"knot", knot}, {"sphere", sphere}, {"dragon", shape::dragon}, {"jug", shape::jug}}};

grf::Scene scene_of(Mesh mesh, const std::string& name, const std::string& brdf, const std::string& pdf) {
  mesh.name = name;
  if (!brdf.empty()) mesh.surfaces[0].brdf = grf::Reference{brdf, {}};
  if (!pdf.empty()) mesh.surfaces[0].pdf = grf::Reference{pdf, {}};
  grf::Scene scene;
  grf::Block block;
  block.content = grf::Shared<Mesh>(std::move(mesh));
  scene.contents.blocks.push_back(std::move(block));
  return scene;
}

}  // namespace

int main(int argc, char** argv) {
  const auto word = [&](int i) { return std::string(argc > i ? argv[i] : ""); };
  const std::string count = word(2);
  int triangles = 0;
  std::from_chars(count.data(), count.data() + count.size(), triangles);
  const auto maker =
      std::find_if(Makers.begin(), Makers.end(), [&](const Maker& one) { return one.name == word(1); });
  if (argc < 4 || argc > 6 || maker == Makers.end() || triangles < 100 || triangles > 100'000'000) {
    fmt::print(
        stderr,
        "usage: make_shape knot|sphere|dragon|jug TRIANGLES FILE.grf [BRDF [PDF]]\n"
        "TRIANGLES from 100 to 100000000: what comes nearest. BRDF, PDF: names of definitions where the file "
        "is included\n");
    return 2;
  }
  grf::Diagnostics diagnostics;
  if (grf::write(scene_of(maker->make(triangles), word(1), word(4), word(5)), word(3), diagnostics)) return 0;
  fmt::print(stderr, "{}", diagnostics.to_text());
  return 1;
}
