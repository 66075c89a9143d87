#include "renderer/transport/integrators/naive.h"

#include <vector>

#include "renderer/transport/integrators/scattering.h"
#include "renderer/transport/processor_clock.h"

namespace transport {
namespace {

using reflectance::Reflector;
using reflectance::ScatterSample;
using reflectance::Uniforms;

class NaivePaths {
 public:
  NaivePaths(const CompiledScene& scene, const IntegratorSettings& settings, PathNumbers& numbers,
             RayCounter& counter)
      : scene_(scene), settings_(settings), numbers_(numbers), counter_(counter) {}

  Rgb run(const Ray& ray, const std::optional<Rgb>& behind);

 private:
  Rgb follow(Ray ray, int path, bool was_scattered);
  std::vector<ScatterSample> draw_secondary(const Scattering& scattering);
  std::optional<ScatterSample> draw(const Scattering& scattering, const Uniforms& xi);
  std::optional<SurfacePoint> intersect(const Ray& ray);
  std::optional<Ray> scattered(const Scattering& scattering, const ScatterSample& drawn) const;
  Rgb emission(const SurfacePoint& point, const Ray& ray) const;
  Rgb radiance_from_outside(const Ray& ray) const;
  const PointSet& points_of(int events);

  const CompiledScene& scene_;
  const IntegratorSettings& settings_;
  PathNumbers& numbers_;
  RayCounter& counter_;
  /// A set of samples per bounce, with one sample per path.
  std::vector<PointSet> points_;
};

Uniforms uniforms(const Uniform4& xi) { return {xi.xy(), xi.z}; }

std::optional<SurfacePoint> NaivePaths::intersect(const Ray& ray) {
  ++counter_.rays;
  return scene_.intersect(ray);
}

Rgb NaivePaths::emission(const SurfacePoint& point, const Ray& ray) const {
  const bool from_behind = ray.direction.dot(point.geometric_normal) >= 0;
  counter_.note_unless_finite("emission", point.surface->emission, &point);
  return from_behind ? Rgb(0) : point.surface->emission;
}

Rgb NaivePaths::radiance_from_outside(const Ray& ray) const {
  const Rgb radiance =
      settings_.environment ? settings_.environment->radiance(ray.direction) : settings_.background;
  counter_.note_unless_finite(settings_.environment ? "environment map" : "background", radiance, nullptr);
  return radiance;
}

const PointSet& NaivePaths::points_of(int events) {
  const auto index = static_cast<std::size_t>(events);
  while (points_.size() <= index) points_.push_back(numbers_.next_set(settings_.secondary_rays));
  return points_[index];
}

// Draws all directions at once, as the thesis does (section 5.3.2): some schemes are faster that way.
std::vector<ScatterSample> NaivePaths::draw_secondary(const Scattering& scattering) {
  std::vector<Uniforms> xi;
  for (int i = 0; i < settings_.secondary_rays; ++i) xi.push_back(uniforms(points_of(0)[i]));
  std::vector<ScatterSample> drawn;
  const std::uint64_t start = processor_ticks();
  scattering.reflector.sample_many(scattering.u, xi, drawn);
  counter_.sampling_ticks += processor_ticks() - start;
  return drawn;
}

std::optional<ScatterSample> NaivePaths::draw(const Scattering& scattering, const Uniforms& xi) {
  if (!settings_.measures_sampling) return scattering.reflector.sample(scattering.u, xi);
  const std::uint64_t start = processor_ticks();
  auto drawn = scattering.reflector.sample(scattering.u, xi);
  counter_.sampling_ticks += processor_ticks() - start;
  return drawn;
}

/// Returns the scattered ray; empty if the surface blocks it.
std::optional<Ray> NaivePaths::scattered(const Scattering& scattering, const ScatterSample& drawn) const {
  counter_.note_unless_finite("colour", scattering.point.colour, &scattering.point);
  counter_.note_unless_finite("weight of a sampled direction", drawn.weight, &scattering.point);
  const Vec3f direction = scattering.frame.to_world(drawn.direction);
  if (!scattering.is_above(direction)) return std::nullopt;
  if (drawn.is_mirror && !settings_.reflects_mirrors) return std::nullopt;
  auto ray = scattering.ray_towards(scene_, direction, counter_.rays);
  if (ray && !drawn.is_mirror) ray->cone = ray->cone.widened(drawn.density);
  return ray;
}

/// The radiance along a ray that was scattered once, or reflected specularly.
Rgb NaivePaths::follow(Ray ray, int path, bool was_scattered) {
  Rgb throughput(1);
  Rgb radiance(0);
  for (int events = 1;; ++events) {
    const auto point = intersect(ray);
    if (!point) return radiance + throughput * radiance_from_outside(ray);
    radiance += throughput * emission(*point, ray);
    const Reflector* reflector = scene_.reflector(*point->surface);
    if (reflector == nullptr || events >= settings_.depth) return radiance;
    if (was_scattered && !point->surface->interreflects) return radiance;
    const Scattering scattering(*point, *reflector, -ray.direction);
    const auto drawn = draw(scattering, uniforms(points_of(events)[path]));
    if (!drawn) return radiance;
    throughput *= drawn->weight * point->colour;
    const auto next = scattered(scattering, *drawn);
    if (!next || reflectance::is_black(throughput)) return radiance;
    was_scattered = was_scattered || !drawn->is_mirror;
    ray = *next;
  }
}

Rgb NaivePaths::run(const Ray& ray, const std::optional<Rgb>& behind) {
  const auto point = intersect(ray);
  if (!point && behind) counter_.note_unless_finite("backplate", *behind, nullptr);
  if (!point) return behind ? *behind : radiance_from_outside(ray);
  const Rgb own = emission(*point, ray);
  const Reflector* reflector = scene_.reflector(*point->surface);
  if (reflector == nullptr || settings_.depth == 0) return own;
  const Scattering scattering(*point, *reflector, -ray.direction);
  Imath::V3d sum(0);
  int path = 0;
  for (const ScatterSample& drawn : draw_secondary(scattering)) {
    const Rgb weight = drawn.weight * point->colour;
    const auto next = scattered(scattering, drawn);
    if (next && !reflectance::is_black(weight))
      sum += Imath::V3d(weight * follow(*next, path, !drawn.is_mirror));
    ++path;
  }
  return own + Rgb(sum / settings_.secondary_rays);
}

}  // namespace

Rgb naive_radiance(const CompiledScene& scene, const IntegratorSettings& settings, const Ray& ray,
                   const std::optional<Rgb>& behind, PathNumbers& numbers, RayCounter& counter) {
  return NaivePaths(scene, settings, numbers, counter).run(ray, behind);
}

}  // namespace transport
