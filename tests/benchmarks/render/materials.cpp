#include "tests/benchmarks/render/materials.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "tests/benchmarks/render/pictures.h"
#include "tests/benchmarks/render/renderers.h"
#include "tests/benchmarks/render/scenes.h"
#include "tests/reflectance/random_walk.h"

namespace benchmark {
namespace {

namespace fs = std::filesystem;
using image::Image;

/// How far the image reaches from its centre, in radii of the sphere.
constexpr double Reach = 1.1;

/// The radii that means reach to. The outlines of a mesh and of a sphere differ, and Fresnel's reflectance
/// grows fast towards them.
constexpr double Rim = 0.98;
constexpr double Inner = 0.85;

Image render_sphere(Renderer renderer, const fs::path& op, const MaterialSettings& settings) {
  Job job;
  job.op = op;
  job.image = op.parent_path() / (name_of(renderer) + ".exr");
  job.size = settings.size;
  job.samples = settings.samples;
  job.seed = 1;
  job.threads = settings.threads;
  render(renderer, job);
  return read_picture(job.image);
}

/// Smith's Lambda of GGX for the cosine of an angle.
double lambda(double c, double alpha) {
  const double tan2 = (1 - c * c) / (c * c);
  return (std::sqrt(1 + alpha * alpha * tan2) - 1) / 2;
}

double masking_shadowing(double u, double v, double alpha, Masking masking) {
  if (masking == Masking::HeightCorrelated) return 1 / (1 + lambda(u, alpha) + lambda(v, alpha));
  return 1 / ((1 + lambda(u, alpha)) * (1 + lambda(v, alpha)));
}

/// Fresnel's reflectance of a dielectric in air.
double dielectric(double c, double ior) {
  const double inside = std::sqrt(1 - (1 - c * c) / (ior * ior));
  const double s = (c - ior * inside) / (c + ior * inside);
  const double p = (inside - ior * c) / (inside + ior * c);
  return (s * s + p * p) / 2;
}

/// The albedo for a view, integrated over microfacet normals that are distributed as D cos.
double albedo(double c, double alpha, double ior, Masking masking) {
  constexpr int Steps = 256;
  const double sine = std::sqrt(1 - c * c);
  double sum = 0;
  for (int i = 0; i < Steps; ++i) {
    const double xi = (i + 0.5) / Steps;
    const double hz = std::sqrt((1 - xi) / (1 + (alpha * alpha - 1) * xi));
    for (int j = 0; j < Steps; ++j) {
      const double hx = std::sqrt(1 - hz * hz) * std::cos(std::numbers::pi * (j + 0.5) / Steps);
      const double along = sine * hx + c * hz;
      const double vz = 2 * along * hz - c;
      if (along <= 0 || vz <= 0) continue;
      const double reflectance = ior == 0 ? 1 : dielectric(along, ior);
      sum += reflectance * masking_shadowing(c, vz, alpha, masking) * along / (c * hz);
    }
  }
  return sum / (Steps * Steps);
}

/// The mean in white surroundings by random walks over the facets.
double walked(double alpha, double ior) {
  constexpr int Walks = 1'000'000;
  test::RandomWalk walk(alpha, 1);
  double sum = 0;
  for (int i = 0; i < Walks; ++i) {
    const double radius2 = Inner * Inner * (i + 0.5) / Walks;
    const Imath::V3d u(std::sqrt(radius2), 0, std::sqrt(1 - radius2));
    sum += walk.run(u, [&](double c) { return ior == 0 ? 1 : dielectric(std::max(0.0, c), ior); }).first;
  }
  return sum / Walks;
}

/// A mean that values are added to.
struct Mean {
  double sum = 0;
  double count = 0;

  void add(double value) {
    sum += value;
    ++count;
  }
  double value() const { return sum / count; }
};

}  // namespace

const std::vector<Material>& materials() {
  static const std::vector<Material> all = {
      {"white metal", "def material = brdf ggx alpha={} F0=1", "Glossy, Multiscatter GGX", 2, 0.7, 0, false},
      {"white metal single", "def material = brdf ggx alpha={} F0=1 scattering=single", "Glossy, GGX", 2, 0.7,
       0},
      {"gold", "def material = brdf ggx alpha={} F0=(1, 0.71, 0.29)",
       "Principled, metallic, Multiscatter GGX"},
      {"gold single", "def material = brdf ggx alpha={} F0=(1, 0.71, 0.29) scattering=single",
       "Principled, metallic, GGX", 2, 0.7},
      {"glass", "def material = brdf ggx alpha={} nreal=1.5", "Principled, black, Multiscatter GGX", 3, 1,
       1.5, false},
      {"glass single", "def material = brdf ggx alpha={} nreal=1.5 scattering=single",
       "Principled, black, GGX", 2, 0.5, 1.5},
      {"dense glass", "def material = brdf ggx alpha={} nreal=1.75", "Principled, black, Multiscatter GGX",
       3},
      {"glass on red",
       "def glass = brdf ggx alpha={} nreal=1.5\ndef red = brdf diffuse kd=(0.6, 0.1, 0.05)\n"
       "def material = brdf combine 1 glass 1 red",
       "Principled, black, Multiscatter GGX, added to Diffuse"}};
  return all;
}

SphereMeans means_of(const Image& image) {
  Mean all, inner, centre, middle, rim;
  const auto place = [&](int i) { return Reach * (2 * (i + 0.5) / image.width - 1); };
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const double radius = std::hypot(place(x), place(y));
      if (radius > Rim) continue;
      const auto& pixel = image.at(x, y);
      const double value = (double(pixel.x) + pixel.y + pixel.z) / 3;
      all.add(value);
      if (radius < Inner) inner.add(value);
      (radius < 0.5 ? centre : radius < Inner ? middle : rim).add(value);
    }
  }
  return {all.value(), inner.value(), centre.value(), middle.value(), rim.value()};
}

std::vector<SphereComparison> compare_material(const Material& material, Surroundings surroundings,
                                               const MaterialSettings& settings) {
  std::vector<SphereComparison> comparisons;
  for (const double roughness : Roughnesses) {
    const double alpha = roughness * roughness;
    const fs::path op = make_material_scene(settings.folder / fmt::format("{}-{}", material.name, roughness),
                                            fmt::format(fmt::runtime(material.in_bpt), alpha),
                                            surroundings == Surroundings::White)
                            .op;
    SphereComparison comparison = {material.name, roughness, {}, {}, {}, {}};
    comparison.bpt_image = render_sphere(Renderer::Bpt, op, settings);
    comparison.cycles_image = render_sphere(Renderer::Cycles, op, settings);
    comparison.bpt = means_of(comparison.bpt_image);
    comparison.cycles = means_of(comparison.cycles_image);
    comparisons.push_back(std::move(comparison));
  }
  return comparisons;
}

double mean_in_white(const Material& material, double roughness, Masking masking) {
  if (!material.is_single) return walked(roughness * roughness, material.ior.value());
  constexpr int Rings = 64;
  double sum = 0;
  for (int i = 0; i < Rings; ++i) {
    const double radius2 = Inner * Inner * (i + 0.5) / Rings;  // rings of equal area
    sum += albedo(std::sqrt(1 - radius2), roughness * roughness, material.ior.value(), masking);
  }
  return sum / Rings;
}

double difference(double bpt, double cycles) { return 100 * (bpt / cycles - 1); }

}  // namespace benchmark
