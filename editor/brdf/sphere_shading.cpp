#include "editor/brdf/sphere_shading.h"

#include <QtConcurrent>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "grf/srgb.h"
#include "renderer/reflectance/glsl_functions.h"

namespace editor {
namespace {

using reflectance::Rgb;
using reflectance::Vec3f;

/// The C++ side of sphere.glsl.
template <class real>
struct SphereFormula {
  using vec3 = Imath::Vec3<real>;
  static constexpr real PI = reflectance::Pi;

  const reflectance::Brdf& brdf;
  const SpecularTable& specular;

  vec3 brdf_value(const vec3& u, const vec3& v) const { return reflectance::evaluate(brdf, u, v); }
  vec3 brdf_specular(const vec3& u) const {
    const float place =
        std::acos(std::clamp(u.z, 0.0F, 1.0F)) / (PI / 2) * static_cast<float>(specular.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), specular.size() - 2);
    const float fraction = place - static_cast<float>(below);
    return specular[below] * (1 - fraction) + specular[below + 1] * fraction;
  }

  static real exp(real x) { return std::exp(x); }
  static real log(real x) { return reflectance::glsl::log(x); }
  static real sqrt(real x) { return std::sqrt(x); }
  static real floor(real x) { return std::floor(x); }
  static real sin(real x) { return reflectance::glsl::sin(x); }
  static real cos(real x) { return reflectance::glsl::cos(x); }
  static real max(real a, real b) { return std::max(a, b); }

#include "editor/brdf/sphere.glsl"
};

}  // namespace

SpecularTable specular_table(const reflectance::Brdf& brdf) {
  SpecularTable table;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double degrees =
        std::min(89.9999, 90.0 * static_cast<double>(i) / static_cast<double>(table.size() - 1));
    table[i] = reflectance::specular_weight(brdf, plot::direction_at(degrees));
  }
  return table;
}

float radius_of(int side) { return 0.48F * static_cast<float>(side); }

Vec3f sphere_normal(int side, double x, double y) {
  const double radius = radius_of(side);
  const auto nx = static_cast<float>((x - 0.5 * side) / radius);
  const auto ny = static_cast<float>((0.5 * side - y) / radius);
  const float z2 = 1 - nx * nx - ny * ny;
  if (z2 <= 0) return Vec3f(nx, ny, -1);
  return {nx, ny, std::sqrt(z2)};
}

QImage displayed(const SphereImage& image, double stops) {
  QImage picture(image.side, image.side, QImage::Format_ARGB32);
  const auto gain = static_cast<float>(std::exp2(stops));
  const float radius = radius_of(image.side);
  const float centre = 0.5F * static_cast<float>(image.side);
  for (int row = 0; row < image.side; ++row) {
    auto* line = reinterpret_cast<QRgb*>(picture.scanLine(row));
    for (int column = 0; column < image.side; ++column) {
      const float x = static_cast<float>(column) + 0.5F - centre;
      const float y = static_cast<float>(row) + 0.5F - centre;
      const float covered = std::clamp(radius - std::hypot(x, y), 0.0F, 1.0F);
      const Rgb& c = image.radiance[static_cast<std::size_t>(row) * image.side + column];
      const auto byte = [&](float value) {
        return static_cast<int>(std::lround(255 * grf::srgb_encoded(std::clamp(gain * value, 0.0F, 1.0F))));
      };
      line[column] = qRgba(byte(c.x), byte(c.y), byte(c.z), static_cast<int>(std::lround(255 * covered)));
    }
  }
  return picture;
}

SphereImage shade_on_cpu(const SphereScene& scene, int samples, const StopFlag& stop) {
  SphereImage image;
  image.side = scene.side;
  image.radiance.resize(static_cast<std::size_t>(scene.side) * scene.side, Rgb(0));
  const SpecularTable specular = specular_table(*scene.brdf);
  std::vector<int> rows(static_cast<std::size_t>(scene.side));
  std::iota(rows.begin(), rows.end(), 0);
  QtConcurrent::blockingMap(rows, [&](int row) {
    SphereFormula<float> formula{*scene.brdf, specular};
    for (int column = 0; column < scene.side && !stop.is_set(); ++column) {
      const Vec3f n = sphere_normal(scene.side, column + 0.5, row + 0.5);
      if (n.z < 0) continue;
      image.radiance[static_cast<std::size_t>(row) * scene.side + column] =
          formula.direct_radiance(n, scene.light, scene.light_strength) +
          formula.sky_sum(n, 0, samples) / static_cast<float>(samples);
    }
  });
  return stop.is_set() ? SphereImage() : image;
}

}  // namespace editor
