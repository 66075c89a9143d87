#include "renderer/transport/integrators/naive.h"

#include <vector>

#include "renderer/transport/integrators/shading_point.h"
#include "renderer/transport/processor_clock.h"

namespace transport {
namespace {

using reflectance::Reflector;
using reflectance::ScatterSample;
using reflectance::Uniforms;

class NaivePaths {
 public:
  NaivePaths(const CompiledScene& scene, const IntegratorSettings& settings, PathSampler& sampler,
             RayCounter& counter)
      : scene_(scene), settings_(settings), sampler_(sampler), counter_(counter), word_(sampler.word()) {}

  Rgb run(const Ray& ray, const std::optional<Rgb>& backplate);

 private:
  Rgb follow(Ray ray, int path, bool was_scattered);
  std::vector<ScatterSample> draw_secondary(const ShadingPoint& shading);
  std::optional<ScatterSample> draw(const ShadingPoint& shading, const Uniforms& xi);
  std::optional<SurfacePoint> intersect(const Ray& ray);
  std::optional<Ray> scattered(const ShadingPoint& shading, const ScatterSample& drawn) const;
  Rgb emission(const SurfacePoint& point, const Ray& ray) const;
  Rgb radiance_from_outside(const Ray& ray) const;
  const SampleSet& points_of(int bounces);

  const CompiledScene& scene_;
  const IntegratorSettings& settings_;
  PathSampler& sampler_;
  RayCounter& counter_;
  /// A set of samples per bounce, with one sample per path.
  std::vector<SampleSet> points_;
  std::uint32_t word_;  ///< random, for all rays together
  std::uint32_t casts_ = 0;
};

Uniforms uniforms(const Uniform4& xi) { return {xi.xy(), xi.z}; }

std::optional<SurfacePoint> NaivePaths::intersect(const Ray& ray) {
  ++counter_.rays;
  return scene_.intersect(ray, scene_.has_cutouts() ? hash(word_, casts_++) : 0);
}

Rgb NaivePaths::emission(const SurfacePoint& point, const Ray& ray) const {
  const bool from_behind = ray.direction.dot(point.geometric_normal) >= 0;
  counter_.check_finite("emission", point.surface->emission, &point);
  return from_behind ? Rgb(0) : point.surface->emission;
}

Rgb NaivePaths::radiance_from_outside(const Ray& ray) const {
  const Rgb radiance =
      settings_.environment ? settings_.environment->radiance(ray.direction) : settings_.background;
  counter_.check_finite(settings_.environment ? "environment map" : "background", radiance, nullptr);
  return radiance;
}

const SampleSet& NaivePaths::points_of(int bounces) {
  const auto index = static_cast<std::size_t>(bounces);
  while (points_.size() <= index) points_.push_back(sampler_.next_set(settings_.secondary_rays));
  return points_[index];
}

// Draws all directions at once, as the thesis does (section 5.3.2): some schemes are faster that way.
std::vector<ScatterSample> NaivePaths::draw_secondary(const ShadingPoint& shading) {
  std::vector<Uniforms> xi;
  for (int i = 0; i < settings_.secondary_rays; ++i) xi.push_back(uniforms(points_of(0)[i]));
  std::vector<ScatterSample> drawn;
  const std::uint64_t start = processor_ticks();
  shading.reflector.sample_many(shading.u, xi, drawn);
  counter_.sampling_ticks += processor_ticks() - start;
  return drawn;
}

std::optional<ScatterSample> NaivePaths::draw(const ShadingPoint& shading, const Uniforms& xi) {
  if (!settings_.measures_sampling) return shading.reflector.sample(shading.u, xi);
  const std::uint64_t start = processor_ticks();
  auto drawn = shading.reflector.sample(shading.u, xi);
  counter_.sampling_ticks += processor_ticks() - start;
  return drawn;
}

/// Returns the scattered ray; empty if the surface blocks it.
std::optional<Ray> NaivePaths::scattered(const ShadingPoint& shading, const ScatterSample& drawn) const {
  counter_.check_finite("colour", shading.point.colour, &shading.point);
  counter_.check_finite("weight of a sampled direction", drawn.weight, &shading.point);
  const Vec3f direction = shading.frame.to_world(drawn.direction);
  if (!shading.is_above(direction)) return std::nullopt;
  if (drawn.is_specular && !settings_.reflects_specular) return std::nullopt;
  auto ray = shading.ray_towards(scene_, direction, counter_.rays);
  if (ray && !drawn.is_specular) ray->cone = ray->cone.widened(drawn.pdf);
  return ray;
}

/// The radiance along a ray that was scattered once, or reflected specularly.
Rgb NaivePaths::follow(Ray ray, int path, bool was_scattered) {
  Rgb throughput(1);
  Rgb radiance(0);
  for (int bounces = 1;; ++bounces) {
    const auto point = intersect(ray);
    if (!point) return radiance + throughput * radiance_from_outside(ray);
    radiance += throughput * emission(*point, ray);
    const Reflector* reflector = scene_.reflector(*point->surface);
    if (reflector == nullptr || bounces >= settings_.depth) return radiance;
    if (was_scattered && !point->surface->interreflects) return radiance;
    const ShadingPoint shading(*point, *reflector, -ray.direction);
    const auto drawn = draw(shading, uniforms(points_of(bounces)[path]));
    if (!drawn) return radiance;
    throughput *= drawn->weight * point->colour;
    const auto next = scattered(shading, *drawn);
    if (!next || reflectance::is_black(throughput)) return radiance;
    was_scattered = was_scattered || !drawn->is_specular;
    ray = *next;
  }
}

Rgb NaivePaths::run(const Ray& ray, const std::optional<Rgb>& backplate) {
  const auto point = intersect(ray);
  if (!point && backplate) counter_.check_finite("backplate", *backplate, nullptr);
  if (!point) return backplate ? *backplate : radiance_from_outside(ray);
  const Rgb own = emission(*point, ray);
  const Reflector* reflector = scene_.reflector(*point->surface);
  if (reflector == nullptr || settings_.depth == 0) return own;
  const ShadingPoint shading(*point, *reflector, -ray.direction);
  Imath::V3d sum(0);
  int path = 0;
  for (const ScatterSample& drawn : draw_secondary(shading)) {
    const Rgb weight = drawn.weight * point->colour;
    const auto next = scattered(shading, drawn);
    if (next && !reflectance::is_black(weight))
      sum += Imath::V3d(weight * follow(*next, path, !drawn.is_specular));
    ++path;
  }
  return own + Rgb(sum / settings_.secondary_rays);
}

}  // namespace

Rgb naive_radiance(const CompiledScene& scene, const IntegratorSettings& settings, const Ray& ray,
                   const std::optional<Rgb>& backplate, PathSampler& sampler, RayCounter& counter) {
  return NaivePaths(scene, settings, sampler, counter).run(ray, backplate);
}

}  // namespace transport
