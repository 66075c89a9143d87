#include "renderer/transport/integrators/naive.h"

#include <vector>

#include "renderer/transport/integrators/glass_scattering.h"
#include "renderer/transport/integrators/shading_point.h"
#include "renderer/transport/processor_clock.h"

namespace transport {
namespace {

using reflectance::Reflector;
using reflectance::ScatterSample;
using reflectance::Uniforms;

/// A ray on its way, which may lead through panes and solids of glass.
struct Way {
  Ray ray;
  Rgb throughput = Rgb(1);
  Rgb radiance = Rgb(0);  ///< of panes that it has passed
  GlassState glass = {};
};

class NaivePaths {
 public:
  NaivePaths(const CompiledScene& scene, const IntegratorSettings& settings, PathSampler& sampler,
             RayCounter& counter)
      : scene_(scene), settings_(settings), sampler_(sampler), counter_(counter), word_(sampler.word()) {}

  Rgb run(const Ray& ray, const std::optional<Rgb>& backplate);

 private:
  Rgb follow(Way way, int path, bool was_scattered);
  Rgb mean_of_secondary(const ShadingPoint& shading, const Way& way);
  std::vector<ScatterSample> draw_secondary(const ShadingPoint& shading);
  std::optional<ScatterSample> draw(const ShadingPoint& shading, const Uniforms& xi);
  std::optional<SurfacePoint> next_point(Way& way);
  std::optional<Ray> scattered(const ShadingPoint& shading, const ScatterSample& drawn) const;
  bool scatter_at_glass(const ShadingPoint& shading, float xi, Way& way) const;
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

/// Returns the point that a ray meets next, behind the panes that it passes.
std::optional<SurfacePoint> NaivePaths::next_point(Way& way) {
  for (;;) {
    ++counter_.rays;
    auto point = scene_.intersect(way.ray, scene_.has_cutouts() ? hash(word_, casts_++) : 0);
    way.throughput *= left_on_way(way.glass.inside, way.ray, point);
    if (!point || !point->surface->is_pane) return point;
    const Rgb emitted = emission(*point, way.ray);
    const reflectance::Glass& pane = glass_of(*scene_.reflector(*point->surface));
    const auto factor =
        pass_pane(pane, *point, settings_.reflects_specular, hash(word_, casts_++), way.ray, way.glass);
    if (!factor) return point;
    way.radiance += way.throughput * emitted;
    way.throughput *= *factor;
  }
}

/// Goes on after glass. False if nothing does.
bool NaivePaths::scatter_at_glass(const ShadingPoint& shading, float xi, Way& way) const {
  const auto step = step_at_glass(shading, way.ray.direction, settings_.reflects_specular, xi, way.glass);
  if (!step) return false;
  way.throughput *= step->weight * shading.point.colour;
  const auto ray = step->passed
                       ? step->passed
                       : scattered(shading, {reflectance::mirrored(shading.u), step->weight, 0, true});
  if (ray) way.ray = *ray;
  return ray.has_value();
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
Rgb NaivePaths::follow(Way way, int path, bool was_scattered) {
  Rgb radiance(0);
  for (int bounces = 1;; ++bounces) {
    const auto point = next_point(way);
    if (!point) return radiance + way.radiance + way.throughput * radiance_from_outside(way.ray);
    radiance += way.throughput * emission(*point, way.ray);
    std::optional<Reflector> varied;
    const Reflector* reflector = scene_.reflector_at(*point, varied);
    if (reflector == nullptr || bounces >= settings_.depth) return radiance + way.radiance;
    if (was_scattered && !point->surface->interreflects) return radiance + way.radiance;
    const ShadingPoint shading(*point, *reflector, -way.ray.direction);
    const Uniforms xi = uniforms(points_of(bounces)[path]);
    if (point->surface->is_glass) {
      if (!scatter_at_glass(shading, xi.choice, way)) return radiance + way.radiance;
    } else {
      const auto drawn = draw(shading, xi);
      if (!drawn) return radiance + way.radiance;
      way.throughput *= drawn->weight * point->colour;
      const auto next = scattered(shading, *drawn);
      if (!next) return radiance + way.radiance;
      was_scattered = was_scattered || !drawn->is_specular;
      way.ray = *next;
    }
    if (reflectance::is_black(way.throughput)) return radiance + way.radiance;
  }
}

/// The mean radiance of many paths from the first hit.
Rgb NaivePaths::mean_of_secondary(const ShadingPoint& shading, const Way& way) {
  Imath::V3d sum(0);
  const Way start{way.ray, Rgb(1), Rgb(0), way.glass};
  if (shading.point.surface->is_glass) {
    for (int path = 0; path < settings_.secondary_rays; ++path) {
      Way next = start;
      if (scatter_at_glass(shading, points_of(0)[path].z, next)) sum += Imath::V3d(follow(next, path, false));
    }
    return Rgb(sum / settings_.secondary_rays);
  }
  int path = 0;
  for (const ScatterSample& drawn : draw_secondary(shading)) {
    const Rgb weight = drawn.weight * shading.point.colour;
    const auto ray = scattered(shading, drawn);
    if (ray && !reflectance::is_black(weight)) {
      Way next = start;
      next.ray = *ray;
      sum += Imath::V3d(weight * follow(next, path, !drawn.is_specular));
    }
    ++path;
  }
  return Rgb(sum / settings_.secondary_rays);
}

Rgb NaivePaths::run(const Ray& ray, const std::optional<Rgb>& backplate) {
  Way way{ray};
  const auto point = next_point(way);
  if (!point && backplate) counter_.check_finite("backplate", *backplate, nullptr);
  if (!point) {
    const Rgb outside = backplate ? *backplate : radiance_from_outside(way.ray);
    return way.radiance + way.throughput * outside;
  }
  const Rgb own = way.radiance + way.throughput * emission(*point, way.ray);
  std::optional<Reflector> varied;
  const Reflector* reflector = scene_.reflector_at(*point, varied);
  if (reflector == nullptr || settings_.depth == 0) return own;
  const ShadingPoint shading(*point, *reflector, -way.ray.direction);
  return own + way.throughput * mean_of_secondary(shading, way);
}

}  // namespace

Rgb naive_radiance(const CompiledScene& scene, const IntegratorSettings& settings, const Ray& ray,
                   const std::optional<Rgb>& backplate, PathSampler& sampler, RayCounter& counter) {
  return NaivePaths(scene, settings, sampler, counter).run(ray, backplate);
}

}  // namespace transport
