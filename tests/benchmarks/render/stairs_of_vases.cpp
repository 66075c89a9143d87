#include <array>
#include <cmath>
#include <numbers>

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

constexpr int PerStep = 7;

/// A surface of revolution about the y axis, 0.42 m high.
class Vase {
 public:
  explicit Vase(Random& random)
      : belly_(random(0.05, 0.09)), phase_(random(-0.6, 0.9)), neck_(random(0.02, 0.05)) {}

  /// A point of the profile: radius and height; `t` is from 0 to 1.
  V3d profile(double t) const {
    const double wave = std::sin(std::numbers::pi * t + phase_ * (1 - t) * t);
    return {neck_ + 0.03 + belly_ * wave * wave * (1.3 - 0.6 * t), 0.42 * t, 0};
  }

  std::string mesh(const std::string& attributes, int segments, const V3d& place, const V3d& uv_scale) const {
    const int rows = segments / 2;
    MeshText mesh;
    for (int row = 0; row <= rows; ++row) {
      const double t = static_cast<double>(row) / rows;
      const V3d at = profile(t);
      const V3d slope = profile(t + 1e-4) - profile(t - 1e-4);
      for (int i = 0; i <= segments; ++i) {
        const double around = static_cast<double>(i) / segments;
        const V3d out(std::cos(-TwoPi * around), 0, std::sin(-TwoPi * around));
        const V3d normal = (out * slope.y - V3d(0, slope.x, 0)).normalized();
        mesh.add_vertex(place + out * at.x + V3d(0, at.y, 0),
                        fmt::format("normal {} uv ({:.4f}, {:.4f})", text_of(normal), uv_scale.x * around,
                                    uv_scale.y * t));
      }
    }
    for (int row = 0; row < rows; ++row) {
      for (int i = 0; i < segments; ++i) {
        const int first = row * (segments + 1) + i;
        mesh.add_face({first, first + 1, first + segments + 2, first + segments + 1});
      }
    }
    return mesh.block(attributes);
  }

 private:
  double belly_, phase_, neck_;
};

std::string vases(int count, int segments) {
  Random random(1);
  std::string text;
  for (int i = 0; i < count; ++i) {
    const Vase vase(random);
    const int step = i / PerStep;
    const V3d place(0.42 * (i % PerStep - 3), 0.28 * step, 1.2 - 0.4 * step);
    // Around it the texture repeats whole times, so that no seam is seen.
    const double around = std::floor(random(1, 5)) * (i % 2 == 0 ? 1 : -1);
    const double along = random(0.5, 3) * (i % 4 < 2 ? 1 : -1);
    const std::string attributes = fmt::format("\"vase {}\" brdf {} texture \"{}\"", i,
                                               i % 3 == 0 ? "glazed" : "matte", texture_name(i));
    text += vase.mesh(attributes, segments, place, {around, along, 0});
  }
  return text;
}

std::string stairs(int steps) {
  MeshText mesh;
  for (int step = 1; step < steps; ++step) {
    mesh.add_box({-1.6, 0, 1.0 - 0.4 * step}, {1.6, 0.28 * step, 1.4 - 0.4 * step});
  }
  return mesh.block("\"stairs\" brdf stone");
}

std::string floor_and_wall(const std::string& texture) {
  MeshText floor;
  const std::array<V3d, 4> corners = {V3d(-6, 0, 6), {6, 0, 6}, {6, 0, -3}, {-6, 0, -3}};
  for (const V3d& corner : corners) {
    floor.add_vertex(corner, fmt::format("uv ({:g}, {:g})", -0.8 * corner.x, 0.8 * corner.z));
  }
  floor.add_face({0, 1, 2, 3});
  MeshText wall;
  wall.add_quad({-6, 0, -3}, {12, 0, 0}, {0, 6, 0});
  return floor.block(fmt::format("\"floor\" brdf matte texture \"{}\"", texture)) +
         wall.block("\"wall\" brdf stone");
}

}  // namespace

std::string texture_name(int index) { return fmt::format("texture_{:02}.png", index); }

std::string stairs_of_vases(int textures, int segments) {
  const int count = textures - 1;
  return "def coat = brdf torrance rough=0.15 nreal=1.5 nimag=0 ks=1 kd=0\n"
         "def matte = brdf diffuse kd=0.9\n"
         "def glazed = brdf combine 1 coat, 1 matte\n"
         "def stone = brdf diffuse kd=(0.5, 0.48, 0.45)\n"
         "begin\n"
         "light begin rgb (60, 55, 48) (-3, 4.5, 2) (1.5, 0, 0) (0, -0.5, 1) end\n"
         "light begin rgb (22, 24, 28) (2, 3.5, 3) (1.2, -0.6, 0) (0, 0, 1.2) end\n" +
         floor_and_wall(texture_name(count)) + stairs((count + PerStep - 1) / PerStep) +
         vases(count, segments) + "end\n";
}

image::Image texture_pattern(int index, int size) {
  Random random(static_cast<std::uint32_t>(index) + 100);
  const auto colour = [&] {
    const double red = random(0.05, 0.9);
    const double green = random(0.05, 0.9);
    return V3d(red, green, random(0.05, 0.9));
  };
  const V3d ground = colour();
  const V3d figure = colour();
  const V3d line = colour() * 0.4;
  const double columns = std::floor(random(1, 5));
  const double rows = std::floor(random(1, 5));
  const double slant = std::floor(random(0, 3));
  image::Image image{size, size, {}};
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const double u = (x + 0.5) / size;
      const double v = (y + 0.5) / size;
      const double wave = std::sin(TwoPi * columns * u) * std::cos(TwoPi * (rows * v + slant * u));
      const bool is_line = std::abs(wave) < 0.08;
      const double grain = std::floor(random(-4, 4)) * 0.015;
      const V3d base = is_line ? line : wave * (index % 2 == 0 ? 1 : v - 0.5) > 0 ? figure : ground;
      image.pixels.emplace_back(base * (1 + grain));
    }
  }
  return image;
}

}  // namespace benchmark
