#include "renderer/studies/brdf_viewer/lit_object.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>

#include "renderer/parallel/loops.h"
#include "renderer/reflectance/shader.h"
#include "renderer/studies/angles.h"

namespace studies {
namespace {

constexpr float FieldOfView = 30;  // degrees, so that the perspective is that of a telephoto lens

float part_above_floor(float x) { return x - std::floor(x); }

Vec3f rotated(const Vec3f& d, float angle) {
  const float c = std::cos(angle);
  const float s = std::sin(angle);
  return {c * d.x - s * d.z, d.y, s * d.x + c * d.z};
}

}  // namespace

Rgb Environment::operator()(const Vec3f& direction) const {
  switch (kind) {
    case Kind::None:
      return Rgb(0);
    case Kind::Constant:
      return scale;
    case Kind::Studio:
      return scale * reflectance::studio_radiance(rotated(direction, turned));
    case Kind::Map:
      return map ? scale * map->radiance(rotated(direction, turned)) : Rgb(0);
  }
  return Rgb(0);
}

float Environment::pdf(const Vec3f& direction) const {
  return drawn ? map->pdf(rotated(direction, turned)) : 0;
}

Vec3f Environment::direction(int index) const {
  return in_world((*drawn)[static_cast<std::size_t>(index % DrawnDirections)]);
}

Vec3f Environment::in_world(const Vec3f& of_map) const { return rotated(of_map, -turned); }

void Environment::set_map(std::shared_ptr<const transport::EnvironmentMap> of_map) {
  map = std::move(of_map);
  drawn = nullptr;
  if (!map || map->is_black()) return;
  auto directions = std::make_shared<std::vector<Vec3f>>();
  for (int i = 0; i < DrawnDirections; ++i) {
    const auto at = [i](double step) { return static_cast<float>(std::fmod(0.5 + step * i, 1)); };
    const auto sample = map->sample(grf::Vec2f(at(0.7548776662466927), at(0.5698402909980532)));
    directions->push_back(sample ? sample->direction : Vec3f(0, 1, 0));
  }
  drawn = std::move(directions);
}

std::optional<reflectance::Brdf> without_diffuse(const reflectance::Brdf& brdf) {
  if (!reflectance::has_glossy_part(brdf) && !reflectance::has_specular_part(brdf)) return std::nullopt;
  std::vector<Rgb> values = reflectance::shader_values(brdf);
  if (values.empty()) return brdf;
  const grf::ModelInfo info = reflectance::brdf_infos()[brdf.index()];
  for (std::size_t i = 0; i < info.parameters.size(); ++i) {
    if (info.parameters[i].is_called("kd")) values[i] = Rgb(0);
  }
  return reflectance::brdf_of_values(brdf.index(), values);
}

LitBrdf lit_brdf(const reflectance::Brdf& brdf, float diffuseness, float specularity) {
  LitBrdf lit = {brdf, reflectance::specular_table(brdf), {}};
  if (diffuseness != 0) lit.parts.push_back({brdf, lit.specular, diffuseness, true});
  if (diffuseness == specularity) return lit;
  if (const auto glossy = without_diffuse(brdf))
    lit.parts.push_back({*glossy, reflectance::specular_table(*glossy), specularity - diffuseness, false});
  return lit;
}

PixelShift::PixelShift(int column, int row) {
  const auto x = static_cast<float>(column);
  const auto y = static_cast<float>(row);
  first = part_above_floor(0.7548776662F * x + 0.5698402910F * y);
  second = part_above_floor(0.8191725134F * x + 0.6710436067F * y);
}

Rgb reflected_radiance(const LitBrdf& brdf, const Lighting& lighting, const Vec3f& normal,
                       const Vec3f& to_eye, const PixelShift& pixel_shift, int first, int count) {
  // Noise is only needed where the environment may have details that few directions would repeat.
  const PixelShift shift = lighting.environment.kind == Environment::Kind::Map ? pixel_shift : PixelShift();
  using Surface = reflectance::LitSurface<Environment>;
  Surface surface(brdf.brdf, brdf.specular, lighting.environment, lighting.lights);
  surface.place(normal, shift.first, shift.second);
  const Vec3f u = surface.eye_from(to_eye);
  Rgb sum = surface.reflected(u, 0, 0);
  if (lighting.environment.kind == Environment::Kind::None || count <= 0) return sum;
  for (const EnvironmentPart& part : brdf.parts) {
    Surface reflecting(part.brdf, part.specular, lighting.environment);
    reflecting.place(normal, shift.first, shift.second);
    sum += (reflecting.reflected(u, first, count) + reflecting.specular(u)) * part.weight;
  }
  return sum;
}

transport::View view_of_object(const grf::Box3d& bounds, double azimuth, double elevation, double distance,
                               double aspect) {
  transport::View view;
  view.field_of_view = FieldOfView;
  const double tangent = std::tan(FieldOfView / 2 * Degree) * std::min(1.0, aspect);
  const double radius = std::max(bounds.isEmpty() ? 1 : bounds.size().length() / 2, 1e-6);
  view.target = bounds.isEmpty() ? grf::Vec3d(0) : bounds.center();
  const double a = azimuth * Degree;
  const double e = elevation * Degree;
  // Objects seldom fill the corners of their boxes.
  constexpr double Filled = 0.75;
  view.eye = view.target + grf::Vec3d(std::cos(e) * std::sin(a), std::sin(e), std::cos(e) * std::cos(a)) *
                               (Filled * radius / std::sin(std::atan(tangent)) * distance);
  return view;
}

std::vector<SurfacePixel> surface_pixels(const transport::CompiledScene& scene, const transport::View& view,
                                         int width, int height, const grf::Vec2f& shift) {
  const transport::Camera camera = transport::camera_of(scene, view, width, height);
  std::vector<SurfacePixel> pixels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  parallel::for_each_index(height, [&](int row) {
    for (int column = 0; column < width; ++column) {
      const transport::Ray ray =
          camera.ray(static_cast<float>(column) + 0.5F + shift.x, static_cast<float>(row) + 0.5F + shift.y);
      const auto point = scene.intersect(ray);
      if (!point) continue;
      const bool is_behind = point->geometric_normal.dot(ray.direction) > 0;
      pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
             static_cast<std::size_t>(column)] = {is_behind ? -point->shading_normal : point->shading_normal,
                                                  -ray.direction};
    }
  });
  return pixels;
}

std::vector<Rgb> shade(const std::vector<SurfacePixel>& pixels, int width, int first_row, const LitBrdf& a,
                       const LitBrdf& b, int split, const Lighting& lighting, int first, int count,
                       const std::function<bool()>& is_stopped) {
  std::vector<Rgb> image(pixels.size(), Rgb(0));
  std::atomic<bool> is_cancelled = false;
  parallel::for_each_index(static_cast<int>(pixels.size()) / width, [&](int row) {
    if (is_cancelled || (is_stopped && is_stopped())) {
      is_cancelled = true;
      return;
    }
    for (int column = 0; column < width; ++column) {
      const auto i =
          static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
      if (pixels[i].normal == Vec3f(0)) continue;
      image[i] = reflected_radiance(column < split ? a : b, lighting, pixels[i].normal, pixels[i].to_eye,
                                    {column, first_row + row}, first, count);
    }
  });
  if (is_cancelled) image.clear();
  return image;
}

}  // namespace studies
