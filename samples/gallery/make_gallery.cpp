// Writes the meshes of the gallery's scenes, identical on every machine. Their BRDF is `material`, which the
// scene defines. They stand on y = 0 about the y axis.
//   block, cushion  a box of side 1 with round edges and uv, and a stuffed one
//   cubes           6 x 6 x 6 cubes of the thesis' scene Cube, in the order and disorder of Georg Nees'
//                   "Schotter" (1968)
//   pile_0 .. 3     84 touching spheres of radius 1 as a tetrahedron, in four files such that no two of one
//                   file touch
//   cove            a paper backdrop 60 wide: a floor that curves up into a wall
//   ring, vase      a torus of height 1, and a surface of revolution of height 2
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <ImathMatrix.h>
#include <fmt/format.h>

#include "grf/text_file.h"
#include "grf/write.h"

namespace {

using grf::Mesh;
using grf::MeshDraft;
using Imath::V3d;

constexpr double Pi = std::numbers::pi;

/// Rounds as exporters do, far more coarsely than math libraries differ.
grf::Vec3f rounded(const V3d& v) {
  const auto round = [](double x) { return static_cast<float>(std::round(x * 1e4) / 1e4 + 0.0); };
  return {round(v.x), round(v.y), round(v.z)};
}

struct Vertex {
  V3d position;
  V3d normal;
};

/// A parametric surface seen from outside: s to the right, t upwards, both from 0 to 1.
using Surface = std::function<Vertex(double s, double t)>;

/// Adds a grid of quads over a surface, with corners at these parameters.
void add_grid(MeshDraft& mesh, const Surface& surface, const std::vector<double>& across,
              const std::vector<double>& up, bool has_uv) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const auto columns = static_cast<std::uint32_t>(across.size());
  for (const double t : up) {
    for (const double s : across) {
      const Vertex vertex = surface(s, t);
      const std::size_t index = mesh.positions.size();
      mesh.normals.set(index, rounded(vertex.normal));
      if (has_uv) mesh.uvs.set(index, {static_cast<float>(s), static_cast<float>(t)});
      mesh.positions.push_back(rounded(vertex.position));
    }
  }
  for (std::uint32_t row = 0; row + 1 < up.size(); ++row) {
    for (std::uint32_t column = 0; column + 1 < columns; ++column) {
      const std::uint32_t at = first + row * columns + column;
      mesh.add_face(std::array{at, at + 1, at + columns + 1, at + columns}, 0);
    }
  }
}

std::vector<double> steps(int count) {
  std::vector<double> values;
  for (int i = 0; i <= count; ++i) values.push_back(static_cast<double>(i) / count);
  return values;
}

/// A box of side 1 that stands on y = 0, with round edges; its top and bottom may bulge.
class Box {
 public:
  Box(double radius, double bulge) : radius_(radius), bulge_(bulge) {}

  Mesh mesh(int arc_steps, int flat_steps) const {
    // Each edge has an arc of 45 degrees, the flat, and another arc.
    std::vector<double> places;
    for (int i = 0; i < arc_steps; ++i) places.push_back(radius_ * i / arc_steps);
    for (const double share : steps(flat_steps)) places.push_back(radius_ + 2 * flat_ * share);
    for (int i = arc_steps - 1; i >= 0; --i) places.push_back(1 - radius_ * i / arc_steps);

    const V3d x(1, 0, 0);
    const V3d y(0, 1, 0);
    const V3d z(0, 0, 1);
    MeshDraft mesh;
    for (const Side& side : {Side{x, y, z}, {-x, y, -z}, {-z, y, x}, {z, y, -x}, {x, -z, y}, {x, z, -y}}) {
      add_grid(
          mesh, [&](double s, double t) { return at(side, s, t); }, places, places, true);
    }
    return mesh;
  }

 private:
  struct Side {
    V3d right, up, out;
  };

  /// Returns the tangent of the angle by which the surface turns away in the arc at an end.
  double lean(double place) const {
    const double into_arc = std::max(radius_ - place, radius_ - (1 - place)) / radius_;
    return std::copysign(std::tan(std::max(0.0, into_arc) * Pi / 4), place - 0.5);
  }

  Vertex at(const Side& side, double s, double t) const {
    const double x = std::clamp(s - 0.5, -flat_, flat_);
    const double y = std::clamp(t - 0.5, -flat_, flat_);
    const V3d direction = (side.right * lean(s) + side.up * lean(t) + side.out).normalized();
    // The wave is 1 in the middle of a flat, and 0 with zero slope at the arcs.
    const double wave = Pi / (2 * flat_);
    const double across = std::pow(std::cos(wave * x), 2);
    const double up = std::pow(std::cos(wave * y), 2);
    const V3d slope = side.right * (wave * std::sin(2 * wave * x) * up) +
                      side.up * (wave * std::sin(2 * wave * y) * across);
    const double bulge = side.out.y == 0 ? 0 : bulge_;
    const V3d core = V3d(0, 0.5, 0) + side.right * x + side.up * y + side.out * flat_;
    return {core + direction * radius_ + side.out * (bulge * across * up),
            (direction + slope * bulge).normalized()};
  }

  double radius_;
  double bulge_;
  double flat_ = 0.5 - radius_;  ///< half of a side's flat part
};

/// Makes a surface of revolution about the y axis, as quads: `profile` is (radius, height) at t.
Mesh turned(const std::function<std::array<double, 2>(double)>& profile, int around, int along) {
  const auto surface = [&](double s, double t) -> Vertex {
    constexpr double Step = 1e-5;
    const auto [radius, height] = profile(t);
    const auto before = profile(t - Step);
    const auto after = profile(t + Step);
    const V3d out(std::sin(2 * Pi * s), 0, std::cos(2 * Pi * s));
    const V3d normal = out * (after[1] - before[1]) - V3d(0, after[0] - before[0], 0);
    return {out * radius + V3d(0, height, 0), normal.normalized()};
  };
  MeshDraft mesh;
  add_grid(mesh, surface, steps(around), steps(along), false);
  return mesh;
}

std::array<double, 2> ring_profile(double t) {
  const double angle = 2 * Pi * t - Pi;
  return {1.2 + 0.5 * std::cos(angle), 0.5 + 0.5 * std::sin(angle)};
}

/// Evaluates a Catmull-Rom spline through evenly spaced points.
std::array<double, 2> vase_profile(double t) {
  constexpr std::array<std::array<double, 2>, 13> Points = {{{0.0, 0.0},
                                                             {0.34, 0.0},
                                                             {0.42, 0.06},
                                                             {0.6, 0.32},
                                                             {0.74, 0.68},
                                                             {0.66, 1.06},
                                                             {0.36, 1.4},
                                                             {0.22, 1.66},
                                                             {0.26, 1.86},
                                                             {0.4, 1.99},
                                                             {0.37, 2.0},
                                                             {0.22, 1.84},
                                                             {0.17, 1.6}}};
  const double place = std::clamp(t, 0.0, 1.0) * (Points.size() - 1);
  const int last = static_cast<int>(Points.size()) - 1;
  const int at = std::min(static_cast<int>(place), last - 1);
  const double x = place - at;
  const auto point = [&](int i) { return Points.at(static_cast<std::size_t>(std::clamp(i, 0, last))); };
  std::array<double, 2> result = {};
  for (std::size_t k = 0; k < 2; ++k) {
    const double a = point(at - 1)[k];
    const double b = point(at)[k];
    const double c = point(at + 1)[k];
    const double d = point(at + 2)[k];
    result.at(k) = b + 0.5 * x * (c - a + x * (2 * a - 5 * b + 4 * c - d + x * (3 * (b - c) + d - a)));
  }
  return result;
}

/// Makes a floor to z = -10 and a wall of height 30, joined by a quarter circle of radius 8.
Mesh cove() {
  constexpr int Steps = 24;
  constexpr double Radius = 8;
  std::vector<Vertex> profile = {{{0, 0, 40}, {0, 1, 0}}};
  for (int i = 0; i <= Steps; ++i) {
    const double angle = Pi / 2 * i / Steps;
    const V3d normal(0, std::cos(angle), std::sin(angle));
    profile.push_back({V3d(0, Radius, -10) - normal * Radius, normal});
  }
  profile.push_back({{0, 30, -10 - Radius}, {0, 0, 1}});
  const double last = static_cast<double>(profile.size() - 1);
  const auto surface = [&](double s, double t) -> Vertex {
    const Vertex& at = profile.at(static_cast<std::size_t>(std::lround(t * last)));
    return {at.position + V3d(60 * s - 30, 0, 0), at.normal};
  };
  MeshDraft mesh;
  add_grid(mesh, surface, {0, 1}, steps(static_cast<int>(last)), false);
  return mesh;
}

/// A generator of numbers from -1 to 1: the standard's distributions differ between libraries.
class Random {
 public:
  double operator()() { return static_cast<double>(engine_()) / 2147483648.0 - 1; }
  V3d in_cube() {
    const double x = (*this)();
    const double y = (*this)();
    return {x, y, (*this)()};
  }

 private:
  std::mt19937 engine_{1968};
};

void add_cube(MeshDraft& mesh, const V3d& centre, double side, const V3d& turn) {
  Imath::M44d rotation;
  rotation.rotate(turn);
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (int i = 0; i < 8; ++i) {
    const V3d corner((i & 1) - 0.5, (i >> 1 & 1) - 0.5, (i >> 2) - 0.5);
    mesh.positions.push_back(rounded(centre + corner * side * rotation));
  }
  constexpr std::array<std::array<std::uint32_t, 4>, 6> Sides = {
      {{4, 5, 7, 6}, {1, 0, 2, 3}, {5, 1, 3, 7}, {0, 4, 6, 2}, {6, 7, 3, 2}, {0, 1, 5, 4}}};
  for (const auto& [a, b, c, d] : Sides) {
    mesh.add_face(std::array{first + a, first + b, first + c}, 0);
    mesh.add_face(std::array{first + a, first + c, first + d}, 0);
  }
}

Mesh cubes() {
  constexpr int Count = 6;
  constexpr double Side = 0.82;
  Random random;
  MeshDraft mesh;
  for (int layer = 0; layer < Count; ++layer) {
    const double disorder = std::pow(layer / (Count - 1.0), 2.5);
    for (int i = 0; i < Count * Count; ++i) {
      const V3d place(i % Count - (Count - 1) / 2.0, layer + Side / 2, i / Count - (Count - 1) / 2.0);
      const V3d shift = random.in_cube() * (0.3 * disorder);
      const V3d turn = random.in_cube() * (0.8 * disorder);
      add_cube(mesh, place + shift + V3d(0, 0.9 * disorder, 0), Side, turn);
    }
  }
  return mesh;
}

/// Writes the spheres of one of four files. i, j and the layer step along three edges of the tetrahedron;
/// sums that differ by 1, 2 or 3 for neighbours separate those of one file.
std::string pile(int file) {
  constexpr int Layers = 7;
  const double row = std::sqrt(3.0);
  const double layer_height = 2 * std::sqrt(2 / 3.0);
  const V3d centre(Layers - 1, 0, row * (Layers - 1) / 3);
  std::string text = "// Spheres of a tetrahedron of 84: made by make_gallery.\n";
  for (int layer = 0; layer < Layers; ++layer) {
    for (int j = 0; j < Layers - layer; ++j) {
      for (int i = 0; i < Layers - layer - j; ++i) {
        if ((i + 2 * j + 3 * layer) % 4 != file) continue;
        const V3d place = V3d(2 * i + j + layer, layer_height * layer, row * (j + layer / 3.0)) - centre;
        const grf::Vec3f p = rounded(place);
        text += fmt::format(
            "transform translation ({}, {}, {}) begin\n  include \"../../shapes/sphere.grf\"\nend\n", p.x,
            p.y, p.z);
      }
    }
  }
  return text;
}

bool write_mesh(Mesh mesh, const std::string& folder, const std::string& name,
                grf::Diagnostics& diagnostics) {
  mesh.name = name;
  mesh.surfaces[0].brdf = grf::Reference{"material", {}};
  grf::Scene scene;
  grf::Block block;
  block.content = grf::Shared<Mesh>(std::move(mesh));
  scene.contents.blocks.push_back(std::move(block));
  return grf::write(scene, folder + "/" + name + ".grf", diagnostics);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: make_gallery FOLDER\n");
    return 2;
  }
  const std::string folder = argv[1];
  grf::Diagnostics diagnostics;
  bool is_written = write_mesh(Box(0.03, 0).mesh(3, 1), folder, "block", diagnostics) &&
                    write_mesh(Box(0.32, 0.05).mesh(5, 5), folder, "cushion", diagnostics) &&
                    write_mesh(cubes(), folder, "cubes", diagnostics) &&
                    write_mesh(cove(), folder, "cove", diagnostics) &&
                    write_mesh(turned(ring_profile, 64, 32), folder, "ring", diagnostics) &&
                    write_mesh(turned(vase_profile, 48, 48), folder, "vase", diagnostics);
  for (int file = 0; file < 4; ++file) {
    is_written =
        is_written && grf::replace_file(folder + fmt::format("/pile_{}.grf", file), pile(file), diagnostics);
  }
  if (!is_written) fmt::print(stderr, "{}", diagnostics.to_text());
  return is_written ? 0 : 1;
}
