#include <cmath>

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

constexpr double Half = 8;  // of the hall's width and length, m
constexpr double Height = 4;

/// A lamp in a cell of the ceiling's grid, which emits downwards.
std::string lamp(double x, double z, double cell, Random& random) {
  const double width = cell * random(0.12, 0.26);
  const double length = cell * random(0.12, 0.36);
  const double turn = random(0, TwoPi / 2);
  const double tilt = random(0, 1) < 0.3 ? random(-0.7, 0.7) : 0;
  const double radiance = 20 * std::exp(random(-1, 1));
  const double warmth = random(0, 1);
  const double y = Height - random(0.15, 0.9);
  const V3d edge1 = V3d(std::cos(turn), 0, std::sin(turn)) * width;
  const V3d across = V3d(-std::sin(turn), 0, std::cos(turn));
  const V3d edge2 = (across * std::cos(tilt) + V3d(0, std::sin(tilt), 0)) * length;
  const V3d colour = V3d(0.8, 0.95, 1.2) * (1 - warmth) + V3d(1.25, 0.85, 0.45) * warmth;
  const V3d corner = V3d(x, y, z) - (edge1 + edge2) / 2;
  return fmt::format("light begin rgb {} {} {} {} end\n", text_of(colour * radiance), text_of(corner),
                     text_of(edge1), text_of(edge2));
}

std::string lamps(int count) {
  Random random(1);
  std::string text;
  const int rows = static_cast<int>(std::lround(std::sqrt(count)));
  const double cell = 2 * Half / rows;
  for (int i = 0; i < count; ++i) {
    const int row = i / rows;
    text += lamp(-Half + cell * (i % rows + 0.5), -Half + cell * (row + 0.5), cell, random);
  }
  return text;
}

std::string hall() {
  const V3d x(2 * Half, 0, 0);
  const V3d y(0, Height, 0);
  const V3d z(0, 0, 2 * Half);
  const V3d low(-Half, 0, -Half);
  MeshText floor;
  floor.add_quad(low, z, x);
  MeshText walls;
  walls.add_quad(low + y, x, z);
  walls.add_quad(low, x, y);
  walls.add_quad(low, y, z);
  walls.add_quad(low + x, z, y);
  walls.add_quad(low + z, y, x);
  return floor.block("\"floor\" brdf floor") + walls.block("\"walls\" brdf white");
}

/// Partitions around groups of tables, and columns.
std::string furniture() {
  MeshText columns, partitions, tables;
  for (const double x : {-4.0, 4.0}) {
    for (const double z : {-4.0, 0.0, 4.0}) {
      columns.add_box({x - 0.2, 0, z - 0.2}, {x + 0.2, Height, z + 0.2});
    }
  }
  Random random(2);
  for (const double z : {-6.0, -3.0, 0.0, 3.0}) {
    for (const double x : {-6.0, -1.6, 1.6, 6.0}) {
      const double height = random(1.1, 2.3);
      partitions.add_box({x - 1.3, 0, z - 1.03}, {x + 1.3, height, z - 0.97});
      const double side = random(0, 1) < 0.5 ? -1.3 : 1.24;
      partitions.add_box({x + side, 0, z - 0.97}, {x + side + 0.06, height, z + 0.6});
      tables.add_box({x - 0.9, 0.7, z - 0.6}, {x + 0.9, 0.74, z + 0.3});
    }
  }
  return columns.block("\"columns\" brdf white") + partitions.block("\"partitions\" brdf partition") +
         tables.block("\"tables\" brdf wood");
}

std::string subjects() {
  std::string text;
  for (const double z : {-3.0, 0.0, 3.0}) {
    for (const double x : {-1.6, 1.6}) {
      text += fmt::format("transform scale (0.3, 0.3, 0.3) translation {} begin include \"sphere.grf\" end\n",
                          text_of({x - 0.4, 0.74, z - 0.2}));
      text += fmt::format("transform scale (0.3, 0.3, 0.3) translation {} begin include \"knot.grf\" end\n",
                          text_of({x + 0.4, 0.74, z - 0.2}));
    }
  }
  return text;
}

}  // namespace

std::string hall_of_lamps(int lamp_count) {
  return "def coat = brdf torrance rough=0.2 nreal=1.5 nimag=0 ks=1 kd=0\n"
         "def base = brdf diffuse kd=(0.45, 0.12, 0.1)\n"
         "def coated = brdf combine 1 coat, 1 base\n"
         "def metal = brdf torrance rough=0.15 nreal=0.37 nimag=2.82 ks=(0.95, 0.8, 0.5) kd=0\n"
         "def white = brdf diffuse kd=(0.7, 0.7, 0.68)\n"
         "def floor = brdf diffuse kd=(0.3, 0.3, 0.32)\n"
         "def partition = brdf diffuse kd=(0.25, 0.4, 0.5)\n"
         "def wood = brdf diffuse kd=(0.5, 0.33, 0.18)\n"
         "begin\n" +
         hall() + furniture() + subjects() + lamps(lamp_count) + "end\n";
}

}  // namespace benchmark
