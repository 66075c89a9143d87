#include "editor/brdf/sphere_shading.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "editor/jobs/parallel_rows.h"
#include "grf/srgb.h"

namespace editor {
namespace {

using reflectance::Rgb;
using reflectance::Vec3f;

}  // namespace

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
  const reflectance::SpecularTable specular = reflectance::specular_table(*scene.brdf);
  const std::array lights = {reflectance::DistantLight{scene.light, Rgb(scene.light_strength)}};
  const bool is_map = scene.environment.kind == studies::Environment::Kind::Map;
  for_each_row(scene.side, [&](int row) {
    reflectance::LitSurface surface(*scene.brdf, specular, scene.environment, lights);
    for (int column = 0; column < scene.side && !stop.is_set(); ++column) {
      const Vec3f n = sphere_normal(scene.side, column + 0.5, row + 0.5);
      if (n.z < 0) continue;
      // Only a map has details that the same few directions in all pixels would repeat.
      const studies::PixelShift shift = is_map ? studies::PixelShift(column, row) : studies::PixelShift();
      surface.place(n, shift.first, shift.second);
      const Vec3f u = surface.in_frame(Vec3f(0, 0, 1));
      image.radiance[static_cast<std::size_t>(row) * scene.side + column] =
          surface.reflected(u, 0, samples) + surface.specular(u);
    }
  });
  return stop.is_set() ? SphereImage() : image;
}

}  // namespace editor
