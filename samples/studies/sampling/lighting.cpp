#include "samples/studies/sampling/lighting.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "renderer/reflectance/halton.h"
#include "renderer/reflectance/schemes/view_square.h"

namespace study {
namespace {

using reflectance::Brdf;
using reflectance::Frame;
using reflectance::mean;
using reflectance::Pi;

constexpr float Degree = Pi / 180;
constexpr float DiscRadius = 5 * Degree;
constexpr float ViewAzimuth = 0.3F;
constexpr int MapHeight = 128;
constexpr int MapWidth = 2 * MapHeight;

/// Maps a point of the environment map, (0,0) its upper left corner and (1,1) the lower right one, to a
/// direction.
Vec3f map_direction(double x, double y) {
  const double theta = std::numbers::pi * y;
  const double phi = 2 * std::numbers::pi * (x - 0.5);
  return Vec3f(static_cast<float>(std::sin(theta) * std::sin(phi)), static_cast<float>(std::cos(theta)),
               static_cast<float>(-std::sin(theta) * std::cos(phi)));
}

Rgb sky_and_ground(const Vec3f& world) {
  if (world.y > 0) {
    const float haze = std::pow(1 - world.y, 3.0F);
    return Rgb(0.25F, 0.45F, 0.8F) * (1 - haze) + Rgb(1.1F, 1.1F, 1.05F) * haze;
  }
  const float squares =
      std::floor(2 * world.x / (0.1F - world.y)) + std::floor(2 * world.z / (0.1F - world.y));
  const bool is_light = std::fmod(std::abs(squares), 2.0F) < 1;
  return is_light ? Rgb(0.35F, 0.28F, 0.2F) : Rgb(0.12F, 0.1F, 0.08F);
}

image::Image picture(const Vec3f& sun) {
  const Rgb sunlight = Rgb(28, 25, 21);
  const float edge = std::cos(6 * Degree);
  image::Image image{MapWidth, MapHeight, {}};
  for (int y = 0; y < MapHeight; ++y) {
    for (int x = 0; x < MapWidth; ++x) {
      const Vec3f world = map_direction((x + 0.5) / MapWidth, (y + 0.5) / MapHeight);
      image.pixels.push_back(world.dot(sun) > edge ? sunlight : sky_and_ground(world));
    }
  }
  return image;
}

std::size_t place_of(const Vec3f& v) {
  const reflectance::Vec2f point = reflectance::to_square(v);
  const auto index = [](float coordinate) {
    const float place = (coordinate + 1) / 2 * PlacesAlongEdge;
    return std::min(static_cast<std::size_t>(std::max(place, 0.0F)), PlacesAlongEdge - 1);
  };
  return index(point.y) * PlacesAlongEdge + index(point.x);
}

}  // namespace

Vec3f in_plane_of_views(float degrees) {
  const float theta = degrees * Degree;
  return reflectance::from_angles(std::cos(theta), std::sin(theta), ViewAzimuth);
}

Surroundings::Surroundings()
    : frame_(Vec3f(0, std::cos(30 * Degree), -std::sin(30 * Degree))),
      map_(picture(frame_.to_world(in_plane_of_views(-ViewDegrees[1] - 4)))) {}

Setting::Setting(const Brdf& brdf, const Vec3f& u, double degrees, const Surroundings& surroundings)
    : view_(u), surroundings_(&surroundings) {
  const auto mirror = -static_cast<float>(degrees);
  axes_ = {in_plane_of_views(mirror), in_plane_of_views(mirror + 30)};
  const Sums map = over_map(brdf);
  keep(Environment, map, map.albedo);
  keep(Highlight, over_disc(brdf, axes_[0]), map.albedo);
  keep(Beside, over_disc(brdf, axes_[1]), map.albedo);
  measure_places(brdf, map.albedo);
}

Setting::Sums Setting::over_disc(const Brdf& brdf, const Vec3f& axis) const {
  constexpr std::uint32_t Points = 1U << 14U;
  const Frame frame(axis);
  const float cap = 1 - std::cos(DiscRadius);
  const double solid_angle = 2 * std::numbers::pi * cap / Points;
  Sums sums;
  for (std::uint32_t i = 0; i < Points; ++i) {
    const reflectance::Vec2f xi = reflectance::halton_point(i).direction;
    const float versine = cap * xi.x;
    const Vec3f v = frame.to_world(
        reflectance::from_angles(1 - versine, std::sqrt(versine * (2 - versine)), 2 * Pi * xi.y));
    if (v.z <= 0) continue;
    const double cosine = solid_angle * v.z;
    sums.once += cosine * mean(evaluate(brdf, view_, v));
    sums.diffuse += cosine / std::numbers::pi;
  }
  sums.squared = sums.once;  // the radiance is 1
  return sums;
}

Setting::Sums Setting::over_map(const Brdf& brdf) const {
  constexpr int Parts = 4;  // of a texel, along an edge
  constexpr int Rows = Parts * MapHeight;
  constexpr int Columns = Parts * MapWidth;
  Sums sums;
  for (int y = 0; y < Rows; ++y) {
    const double height = std::cos(std::numbers::pi * y / Rows) - std::cos(std::numbers::pi * (y + 1) / Rows);
    const double solid_angle = height * 2 * std::numbers::pi / Columns;
    for (int x = 0; x < Columns; ++x) {
      const Vec3f v = surroundings_->frame().to_local(map_direction((x + 0.5) / Columns, (y + 0.5) / Rows));
      if (v.z <= 0) continue;
      const Rgb f = evaluate(brdf, view_, v);
      const Rgb light = surroundings_->radiance(v);
      const double cosine = solid_angle * v.z;
      const double once = mean(f * light);
      sums.albedo += cosine * mean(f);
      sums.once += cosine * once;
      if (mean(f) > 0) sums.squared += cosine * once * once / mean(f);
      sums.diffuse += cosine * mean(light) / std::numbers::pi;
    }
  }
  return sums;
}

void Setting::keep(Light light, const Sums& sums, double albedo) {
  reflected_[light] = sums.once;
  scale_[light] = std::max(sums.once, 1e-3 * sums.diffuse);
  const double variance = albedo * sums.squared - sums.once * sums.once;
  perfect_[light] = std::sqrt(std::max(0.0, variance)) / scale_[light];
}

void Setting::measure_places(const Brdf& brdf, double albedo) {
  constexpr std::size_t Parts = 16;  // per position, along an edge
  constexpr std::size_t Edge = PlacesAlongEdge * Parts;
  constexpr double SolidAngle = 2 * std::numbers::pi / (Edge * Edge);
  const auto coordinate = [](std::size_t i) { return (2 * static_cast<float>(i) + 1) / Edge - 1; };
  for (std::size_t y = 0; y < Edge; ++y) {
    for (std::size_t x = 0; x < Edge; ++x) {
      const Vec3f v = reflectance::from_square(coordinate(x), coordinate(y));
      places_[y / Parts * PlacesAlongEdge + x / Parts] += SolidAngle * v.z * mean(evaluate(brdf, view_, v));
    }
  }
  double squares = 0;
  double variance = 0;
  for (const double place : places_) {
    squares += place * place;
    variance += place * (albedo - place);
  }
  scale_[Anywhere] = std::sqrt(squares);
  perfect_[Anywhere] = std::sqrt(variance / squares);
}

void Setting::Estimate::add(const reflectance::DirectionSample& sample, double share) {
  static const float edge = std::cos(DiscRadius);
  const Vec3f& v = sample.direction;
  const double weight = share * mean(sample.weight);
  if (v.dot(setting_->axes_[0]) > edge) sums_[Highlight] += weight;
  if (v.dot(setting_->axes_[1]) > edge) sums_[Beside] += weight;
  sums_[Environment] += share * mean(sample.weight * setting_->surroundings_->radiance(v));
  places_[place_of(v)] += weight;
}

std::array<double, LightCount> Setting::Estimate::squared_errors() const {
  std::array<double, LightCount> squares = {};
  for (const Light light : {Highlight, Beside, Environment}) {
    squares[light] = std::pow((sums_[light] - setting_->reflected_[light]) / setting_->scale_[light], 2);
  }
  double sum = 0;
  for (std::size_t i = 0; i < PlaceCount; ++i) {
    const double error = places_[i] - setting_->places_[i];
    sum += error * error;
  }
  squares[Anywhere] = sum / (setting_->scale_[Anywhere] * setting_->scale_[Anywhere]);
  return squares;
}

}  // namespace study
