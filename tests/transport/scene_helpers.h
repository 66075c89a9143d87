#pragma once

#include <cmath>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "grf/check.h"
#include "grf/read.h"
#include "renderer/reflectance/scheme.h"
#include "renderer/transport/lights/environment_map.h"
#include "renderer/transport/render.h"

namespace test {

/// Compiles a scene from GRF text; throws the diagnostics on errors.
inline transport::CompiledScene scene_of(const std::string& text,
                                         const transport::CompileSettings& settings = {}) {
  grf::Diagnostics diagnostics;
  const auto scene = grf::read_text(text, "test.grf", diagnostics);
  if (scene && grf::check(*scene, reflectance::catalogue(), diagnostics)) {
    if (auto compiled = transport::compile(*scene, diagnostics, settings)) return std::move(*compiled);
  }
  throw std::runtime_error(diagnostics.to_text());
}

/// Returns settings that copy meshes of up to this many triangles, and instance others.
inline transport::CompileSettings copies_up_to(std::size_t triangles) {
  transport::CompileSettings settings;
  settings.most_copied_triangles = triangles;
  return settings;
}

/// A quad whose front is the side from which its corners are counter-clockwise.
inline std::string quad(const std::string& attributes, const std::string& corners) {
  return "begin mesh " + attributes + " begin vertexs " + corners +
         " end vertexs begin faces (0,1,2,3) end faces end mesh\n";
}

/// A box from -1 to 1 along each axis, with inward fronts.
inline std::string box(const std::string& attributes) {
  return "begin mesh " + attributes +
         " begin vertexs (-1,-1,-1) (1,-1,-1) (1,1,-1) (-1,1,-1) (-1,-1,1) (1,-1,1) (1,1,1) (-1,1,1) "
         "end vertexs begin faces (0,1,2,3) (4,7,6,5) (0,4,5,1) (2,6,7,3) (0,3,7,4) (1,5,6,2) "
         "end faces end mesh ";
}

/// Scales, then rotates about the axes by these angles, then translates.
inline std::string placed(const std::string& what, const transport::Vec3f& scale,
                          const transport::Vec3f& angles, const transport::Vec3f& offset) {
  return fmt::format("transform scale ({},{},{}) rotation ({},{},{}) translation ({},{},{}) begin {} end ",
                     scale.x, scale.y, scale.z, angles.x, angles.y, angles.z, offset.x, offset.y, offset.z,
                     what);
}

/// The map of what is `placed`.
inline grf::Matrix44d map_of(const transport::Vec3f& scale, const transport::Vec3f& angles,
                             const transport::Vec3f& offset) {
  using grf::TransformStep;
  return grf::matrix_of({{TransformStep::Kind::Scale, scale},
                         {TransformStep::Kind::Rotation, angles},
                         {TransformStep::Kind::Translation, offset}});
}

/// A sphere of radius 1 about the origin, of quads and triangles with outward fronts.
inline std::string sphere(const std::string& attributes, int rows, bool normals) {
  const int columns = 2 * rows;
  std::string text = "begin mesh " + attributes + " begin vertexs\n";
  for (int i = 0; i <= rows; ++i) {
    for (int k = 0; k < columns; ++k) {
      const double theta = M_PI * i / rows;
      const double phi = 2 * M_PI * k / columns;
      const std::string p = fmt::format("({},{},{})", static_cast<float>(std::sin(theta) * std::cos(phi)),
                                        static_cast<float>(std::cos(theta)),
                                        static_cast<float>(-std::sin(theta) * std::sin(phi)));
      text += (normals ? "normal " + p + " " : "") + p + "\n";
    }
  }
  text += "end vertexs begin faces\n";
  for (int i = 0; i < rows; ++i) {
    for (int k = 0; k < columns; ++k) {
      const int a = i * columns + k;
      const int b = i * columns + (k + 1) % columns;
      if (i == 0)
        text += fmt::format("({},{},{})\n", a, a + columns, b + columns);
      else if (i == rows - 1)
        text += fmt::format("({},{},{})\n", a, a + columns, b);
      else
        text += fmt::format("({},{},{},{})\n", a, a + columns, b + columns, b);
    }
  }
  return text + "end faces end mesh\n";
}

struct RenderSetup {
  transport::Vec3f eye = transport::Vec3f(0, 0, 4);
  transport::Vec3f target = transport::Vec3f(0);
  int width = 32;
  int height = 32;
  int samples = 16;
  int depth = 5;
  int split_count = 2;
  float background = 0;
  std::uint32_t seed = 0;
  int threads = 0;
  float field_of_view = 45;
  float lens_radius = 0;
  float focus_distance = 0;  ///< 0: to the target
};

inline transport::RenderSettings settings_of(const RenderSetup& setup) {
  transport::RenderSettings settings;
  settings.width = setup.width;
  settings.height = setup.height;
  settings.view.eye = setup.eye;
  settings.view.target = setup.target;
  settings.view.field_of_view = setup.field_of_view;
  settings.view.lens_radius = setup.lens_radius;
  settings.view.focus_distance = setup.focus_distance;
  settings.integrator.background = transport::Rgb(setup.background);
  settings.integrator.depth = setup.depth;
  settings.integrator.split_count = setup.split_count;
  settings.samples = setup.samples;
  settings.seed = setup.seed;
  settings.threads = setup.threads;
  return settings;
}

/// Returns the map of an image with the weights of the renderer's job.
inline std::shared_ptr<const transport::EnvironmentMap> environment_of(image::Image image) {
  return std::make_shared<const transport::EnvironmentMap>(std::move(image), 0.0F,
                                                           transport::EnvironmentMap::Weights::Compensated);
}

/// A floor under a light whose radiance differs per channel.
inline const std::string FloorLight = "light begin rgb (9,8,7) (-1,3,-1) (2,0,0) (0,0,2) end\n";
inline const std::string LitFloor =
    FloorLight + quad("brdf diffuse kd=0.7", "(-3,0,3) (3,0,3) (3,0,-3) (-3,0,-3)");

inline RenderSetup floor_setup(int width, int height, int samples) {
  RenderSetup setup;
  setup.eye = transport::Vec3f(0, 2, 5);
  setup.width = width;
  setup.height = height;
  setup.samples = samples;
  return setup;
}

/// Renders a scene and returns the film.
inline transport::Film render(const transport::CompiledScene& scene, const RenderSetup& setup) {
  transport::Render render(scene, settings_of(setup));
  render.run();
  if (render.rejected_samples() > 0) throw std::runtime_error("samples that are not finite");
  return render.film();
}

struct Estimate {
  double mean = 0;
  double deviation = 0;  ///< of the mean
};

/// The image's mean over pixels and channels, with its standard deviation from the two scramblings.
inline Estimate mean_radiance(const transport::Film& film) {
  const image::Image mean = film.mean();
  const image::Image variance = film.variance();
  Estimate estimate;
  double total_variance = 0;
  const double count = static_cast<double>(mean.pixels.size());
  for (std::size_t i = 0; i < mean.pixels.size(); ++i) {
    estimate.mean += reflectance::mean(mean.pixels[i]) / count;
    // Channels share paths: their errors add up, not their variances.
    const auto& v = variance.pixels[i];
    const double deviation = (std::sqrt(v.x) + std::sqrt(v.y) + std::sqrt(v.z)) / 3;
    total_variance += deviation * deviation / (count * count);
  }
  estimate.deviation = std::sqrt(total_variance);
  return estimate;
}

}  // namespace test
