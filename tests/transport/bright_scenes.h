// High-contrast scenes with visible lamps, which are difficult for an error estimate.
#pragma once

#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "tests/support/paths.h"
#include "tests/support/temporary_folder.h"
#include "tests/transport/error_scenes.h"

namespace test {

/// A scene with the number of samples per pixel at which its error is checked.
struct ErrorCase {
  SampleScene scene;
  int samples = 0;
};

/// Builds scenes in pixel units of a square image: objects stand upright in front of the camera.
class BrightScene {
 public:
  explicit BrightScene(int width) : width_(width) {}

  /// Adds a lamp of this size in pixels, turned anticlockwise; its green is 0.8 of its red, its blue 0.5.
  BrightScene& lamp(double x, double y, double wide, double high, double turn, double radiance) {
    const double c = std::cos(turn);
    const double s = std::sin(turn);
    const double corner_x = x - (wide * c - high * s) / 2 - width_ / 2.0;
    const double corner_y = width_ / 2.0 - y - (wide * s + high * c) / 2;
    text_ += fmt::format("light begin rgb ({},{},{}) ({},{},0) ({},{},0) ({},{},0) end\n", radiance,
                         0.8 * radiance, 0.5 * radiance, step() * corner_x, step() * corner_y,
                         step() * wide * c, step() * wide * s, -step() * high * s, step() * high * c);
    return *this;
  }

  /// Adds rows of equal lamps, each a little wider than the one before.
  BrightScene& lamps(int count, double first, double apart, double wide, double growth, double radiance) {
    for (int i = 0; i < count; ++i) {
      for (int k = 0; k < count; ++k) {
        lamp(first + apart * i, first + apart * k, wide + growth * i, wide + growth * k, 0.1 * i, radiance);
      }
    }
    return *this;
  }

  /// Adds lines across most of the image, each thicker by a quarter of a pixel than the one before.
  BrightScene& strips(int count, double thickness, double turn, double radiance) {
    for (int i = 0; i < count; ++i) {
      lamp(width_ / 2.0, width_ * (i + 0.6) / count, 0.75 * width_, thickness + 0.25 * i, turn * i, radiance);
    }
    return *this;
  }

  /// Adds a wall behind everything, under a lamp out of view.
  BrightScene& wall(const std::string& attributes, double radiance = 6) {
    text_ += quad(attributes,
                  "uv (0,0) (-3,-3,-0.5) uv (1,0) (3,-3,-0.5) uv (1,1) (3,3,-0.5) uv (0,1) (-3,3,-0.5)");
    text_ += fmt::format("light begin rgb ({0},{0},{1}) (-0.5,2,2) (0,1,0) (1,0,0) end\n", radiance,
                         0.7 * radiance);
    return *this;
  }

  /// Adds a sphere with this BRDF, sized in pixels.
  BrightScene& ball(double x, double y, double radius, const std::string& attributes) {
    const auto size = static_cast<float>(step() * radius);
    text_ += placed(sphere(attributes, 12, true), transport::Vec3f(size), transport::Vec3f(0),
                    transport::Vec3f(static_cast<float>(step() * (x - width_ / 2.0)),
                                     static_cast<float>(step() * (width_ / 2.0 - y)), -0.25F));
    return *this;
  }

  ErrorCase with(const std::string& name, int samples, float background = 0) const {
    RenderSetup setup;
    setup.width = width_;
    setup.height = width_;
    setup.background = background;
    setup.depth = 3;
    return {{name, scene_of(text_), settings_of(setup)}, samples};
  }

 private:
  /// The size of a pixel at that distance.
  double step() const { return 2 * std::tan(std::numbers::pi / 8) * 4 / width_; }

  int width_;
  std::string text_;
};

/// The Cornell box with its lamp in view.
inline ErrorCase cornell_case(int width, int samples) {
  ErrorCase result{sample_scene(std::string(GRANADA_SOURCE_DIR) + "/samples/cornell_box/cornell_box.op"),
                   samples};
  result.scene.name = fmt::format("cornell box {} {}", width, samples);
  result.scene.settings.width = width;
  result.scene.settings.height = width;
  return result;
}

/// A wall with a texture of dark and bright squares.
inline ErrorCase checker_case(int width, int texels, int samples) {
  std::vector<float> values;
  for (int i = 0; i < texels * texels; ++i) {
    values.insert(values.end(), 3, (i % texels + i / texels) % 2 == 0 ? 0.9F : 0.01F);
  }
  std::string bytes = fmt::format("PF\n{0} {0}\n-1.0\n", texels);
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float));
  const TemporaryFolder folder;
  const std::string file = folder.add("checker.pfm", bytes);
  return BrightScene(width)
      .wall("brdf diffuse kd=0.9 texture \"" + file + "\"")
      .with(fmt::format("checker {}", texels), samples);
}

/// A random scene of lamps, spheres and surroundings.
inline ErrorCase random_case(std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const auto log_uniform = [&](double low, double high) { return low * std::pow(high / low, uniform(0, 1)); };
  const auto one_of = [&](const auto& values) {
    return values[std::uniform_int_distribution<std::size_t>(0, std::size(values) - 1)(random)];
  };
  const int width = one_of(std::array{64, 64, 80, 96, 128});
  int samples = one_of(std::array{4, 8, 12, 16, 32, 64, 128});
  while (samples > 4 && width * width * samples > 300'000) samples = std::max(4, samples / 4 * 2);
  BrightScene scene(width);
  if (uniform(0, 1) < 0.5) scene.wall("brdf diffuse kd=0.6", log_uniform(1, 30));
  for (int i = 0, count = static_cast<int>(uniform(1, 13)); i < count; ++i) {
    const double turn = uniform(0, 1) < 0.5 ? 0 : uniform(0, std::numbers::pi);
    scene.lamp(uniform(4, width - 4), uniform(4, width - 4), log_uniform(2, 40), log_uniform(0.4, 20), turn,
               log_uniform(0.5, 60));
  }
  for (int i = 0, count = static_cast<int>(uniform(0, 3)); i < count; ++i) {
    const std::string brdf = one_of(std::array<std::string, 3>{
        "brdf diffuse kd=0.5", "brdf ward sx=0.05 sy=0.05 ks=0.5 kd=0.2", "brdf specular ks=0.8"});
    scene.ball(uniform(8, width - 8), uniform(8, width - 8), log_uniform(3, 20), brdf);
  }
  const auto background = static_cast<float>(one_of(std::array{0.0, 0.0, 0.02, 0.3, 1.0}));
  return scene.with(fmt::format("random scene {}", seed), samples, background);
}

}  // namespace test
