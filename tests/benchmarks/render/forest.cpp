#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "samples/shapes/scene_text.h"
#include "tests/benchmarks/render/generated_scenes.h"

namespace benchmark {
namespace {

using shape::MeshText;
using shape::Random;
using shape::text_of;
using shape::TwoPi;
using shape::V3d;

constexpr double Spacing = 3.2;  // of trees, m

double height_of_ground(double x, double z) {
  return 3.5 * std::sin(0.045 * x) * std::cos(0.038 * z) + 1.2 * std::sin(0.11 * x + 0.07 * z);
}

/// A cone of six sides.
void add_cone(MeshText& mesh, const V3d& foot, const V3d& tip, double radius) {
  constexpr int Sides = 6;
  std::vector<int> ring;
  for (int i = 0; i < Sides; ++i) {
    const double angle = -TwoPi * i / Sides;
    ring.push_back(mesh.add_vertex(foot + V3d(std::cos(angle), 0, std::sin(angle)) * radius));
  }
  const int top = mesh.add_vertex(tip);
  for (std::size_t i = 0; i < Sides; ++i) mesh.add_face({ring[i], ring[(i + 1) % Sides], top});
}

V3d random_direction(Random& random) {
  const double y = random(-1, 1);
  const double angle = random(0, TwoPi);
  const double radius = std::sqrt(1 - y * y);
  return {radius * std::cos(angle), y, radius * std::sin(angle)};
}

/// Leaves at random in an egg of 3.6 m, most of them near its surface.
void add_leaf(MeshText& mesh, Random& random) {
  const V3d out = random_direction(random);
  const double depth = std::cbrt(random(0.3, 1));
  const V3d centre = V3d(0, 3.4, 0) + V3d(1.35, 1.8, 1.35) * out * depth;
  const V3d along = (out + random_direction(random)).normalized() * random(0.1, 0.2);
  const V3d across = along.cross(random_direction(random)).normalized() * 0.09;
  mesh.add_quad(centre - along - across, along * 2, across * 2);
}

std::string tree(int leaves) {
  Random random(1);
  MeshText mesh;
  mesh.add_attributes("brdf bark");
  add_cone(mesh, {0, -0.3, 0}, {0, 4.6, 0}, 0.16);
  for (int i = 0; i < 12; ++i) {
    const double angle = 2.4 * i;  // about the golden angle
    const double reach = 1.1 - 0.05 * i;
    const V3d foot(0, 1.4 + 0.2 * i, 0);
    add_cone(mesh, foot, foot + V3d(reach * std::cos(angle), 0.8, reach * std::sin(angle)), 0.05);
  }
  mesh.add_attributes("brdf leaf");
  for (int i = 0; i < leaves; ++i) add_leaf(mesh, random);
  return mesh.block("");
}

std::string ground(double half) {
  constexpr int Cells = 80;
  MeshText mesh;
  for (int row = 0; row <= Cells; ++row) {
    for (int column = 0; column <= Cells; ++column) {
      const double x = half * (2.0 * column / Cells - 1);
      const double z = half * (2.0 * row / Cells - 1);
      mesh.add_vertex({x, height_of_ground(x, z), z});
    }
  }
  for (int row = 0; row < Cells; ++row) {
    for (int column = 0; column < Cells; ++column) {
      const int at = row * (Cells + 1) + column;
      const int below = at + Cells + 1;
      mesh.add_face({at, below, below + 1});
      mesh.add_face({at, below + 1, at + 1});
    }
  }
  return mesh.block("\"ground\" brdf grass");
}

/// Trees in a grid from which each is moved, turned and scaled.
std::string trees(int count) {
  Random random(2);
  std::string text;
  const int rows = static_cast<int>(std::lround(std::sqrt(count)));
  for (int i = 0; i < count; ++i) {
    const int row = i / rows;
    const double x = Spacing * (i % rows - 0.5 * (rows - 1) + random(-0.45, 0.45));
    const double z = Spacing * (row - 0.5 * (rows - 1) + random(-0.45, 0.45));
    const double size = random(0.6, 1.3);
    const double width = size * random(0.8, 1.2);
    const double turn = random(0, TwoPi);
    text += fmt::format("transform scale {} rotation {} translation {} begin use tree end\n",
                        text_of({width, size, width}), text_of({0, turn, 0}),
                        text_of({x, height_of_ground(x, z), z}));
  }
  return text;
}

}  // namespace

std::string forest(int tree_count, int leaves) {
  return "def bark = brdf diffuse kd=(0.2, 0.13, 0.08)\n"
         "def leaf = brdf diffuse kd=(0.2, 0.36, 0.08)\n"
         "def grass = brdf diffuse kd=(0.36, 0.32, 0.16)\n"
         "def tree = " +
         tree(leaves) + "begin\n" + ground(0.55 * Spacing * std::sqrt(tree_count)) + trees(tree_count) +
         "end\n";
}

}  // namespace benchmark
