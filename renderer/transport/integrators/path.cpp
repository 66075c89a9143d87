#include "renderer/transport/integrators/path.h"

#include <array>
#include <cmath>
#include <string_view>
#include <utility>
#include <variant>

#include "renderer/transport/integrators/glass_scattering.h"
#include "renderer/transport/integrators/power_heuristic.h"
#include "renderer/transport/integrators/shading_point.h"
#include "renderer/transport/lights/environment_probability.h"
#include "renderer/transport/processor_clock.h"

namespace transport {
namespace {

using reflectance::Diffuse;
using reflectance::Reflection;
using reflectance::Reflector;
using reflectance::ScatterSample;

const Diffuse& diffuse_of(const Reflector& reflector) { return *std::get_if<Diffuse>(&reflector.brdf()); }

/// A path, advanced bounce by bounce.
template <PathEffects Has>
class Path {
 public:
  Path(const CompiledScene& scene, const IntegratorSettings& settings, const Ray& ray,
       const PathSampler& sampler, RayCounter& counter)
      : scene_(scene), settings_(settings), sampler_(sampler), counter_(counter), ray_(ray) {
    if constexpr (Has.environment) {
      resamples_ = settings.resampling && settings.environment && !settings.environment->is_black();
      if (!resamples_) {
        environment_probability_ =
            environment_probability(settings.environment.get(), scene.lights(), scene.bounds());
      }
    }
  }

  /// Continues after `events` bounces.
  Rgb run(const std::optional<Rgb>& backplate, int bounces = 0);
  /// Starts with a bounce off a white diffuse surface instead of a camera ray.
  GatherSample gather(const ShadingPoint& shading);

 private:
  template <class Value>
  const Value& check_finite(std::string_view term, const Value& value, const SurfacePoint* where) const;
  Rgb radiance_from_outside() const;
  void add(const Rgb& radiance, std::uint32_t emitter, std::uint32_t reflector, int bounces);
  void add_emission(const SurfacePoint& point);
  void add_reflected(const ShadingPoint& shading, const Rgb& radiance, std::uint32_t emitter);
  void add_direct_light(const ShadingPoint& shading, const Uniform4& xi);
  void add_area_light(const ShadingPoint& shading, float choice, const Vec2f& xi);
  void add_environment_light(const ShadingPoint& shading, const Vec2f& xi);
  void add_resampled_light(const ShadingPoint& shading);
  std::optional<Rgb> unshadowed_contribution(const ShadingPoint& shading, const Vec3f& direction,
                                             float light_pdf);
  Reflection reflect(const ShadingPoint& shading, const Vec3f& v) const;
  std::optional<ScatterSample> sample(const ShadingPoint& shading, const Uniform4& xi);
  bool scatter(const ShadingPoint& shading, const Uniform4& xi);
  bool leave(const ShadingPoint& shading, const Vec3f& direction, float pdf);
  bool scatter_at_glass(const ShadingPoint& shading, float xi);
  std::optional<SurfacePoint> next_point();
  bool has_irradiance(const SurfacePoint& point, const Reflector& reflector) const;
  bool survives(float xi);
  Rgb split(const ShadingPoint& shading, int bounces);

  const CompiledScene& scene_;
  const IntegratorSettings& settings_;
  PathSampler sampler_;
  RayCounter& counter_;
  Ray ray_;
  Rgb throughput_ = Rgb(1);
  Rgb radiance_ = Rgb(0);
  /// The solid-angle pdf of the ray, summed over all split paths, where a light could have been sampled
  /// instead; 0 for camera rays and specular directions.
  float pdf_ = 0;
  /// The point that the ray was scattered from, with its shading normal.
  Vec3f from_, from_normal_;
  float environment_probability_ =
      0;  ///< the probability of sampling the environment map rather than an emitter
  bool resamples_ = false;
  reflectance::Resampler resampler_;
  /// The environment's light along the ray was already added at its origin.
  bool has_environment_ = false;
  /// True while all hits were specular, and baked irradiance can be used.
  bool takes_irradiance_ = settings_.uses_irradiance;
  bool was_scattered_ = false;        ///< by a non-specular bounce
  bool may_split_ = true;             ///< no non-specular hit yet
  int split_count_ = 1;               ///< number of paths that continue from this hit
  Vec3f light_direction_ = Vec3f(0);  ///< to the last light sample that could be reflected
  GlassState glass_;                  ///< set only where there is glass
  // Set only where contributions are listed.
  int bounces_ = 0;                              ///< before the current ray
  std::uint32_t from_reflector_ = InvalidIndex;  ///< of the point that the ray was scattered from
  float fraction_ = 1;                           ///< of the paths that continue after splits
};

/// Adds to the radiance of the path, and lists the contribution.
template <PathEffects Has>
void Path<Has>::add(const Rgb& radiance, std::uint32_t emitter, std::uint32_t reflector, int bounces) {
  radiance_ += radiance;
  if constexpr (Has.observe) {
    if (counter_.contributions != nullptr && !reflectance::is_black(radiance))
      counter_.contributions->push_back({radiance * fraction_, emitter, reflector, bounces});
  }
}

/// Adds light that is reflected at a hit without another bounce.
template <PathEffects Has>
void Path<Has>::add_reflected(const ShadingPoint& shading, const Rgb& radiance, std::uint32_t emitter) {
  add(radiance, emitter, shading.point.surface->reflector, bounces_ + 1);
}

/// Returns the value; an observing kernel records the first one that is not finite.
template <PathEffects Has>
template <class Value>
const Value& Path<Has>::check_finite(std::string_view term, const Value& value,
                                     const SurfacePoint* where) const {
  if constexpr (Has.observe) counter_.check_finite(term, value, where);
  return value;
}

template <PathEffects Has>
void Path<Has>::add_emission(const SurfacePoint& point) {
  const Rgb& emission = check_finite("emission", point.surface->emission, &point);
  if (reflectance::is_black(emission) || ray_.direction.dot(point.geometric_normal) >= 0) return;
  float weight = 1;
  if (pdf_ > 0 && point.emitter != InvalidIndex) {
    const float light_pdf = scene_.lights().pdf(from_, from_normal_, point.emitter, ray_.direction);
    weight = power_heuristic(pdf_, (1 - environment_probability_) * light_pdf);
    check_finite("emission's weight", weight, &point);
  }
  add(throughput_ * emission * weight, point.emitter, from_reflector_, bounces_);
}

template <PathEffects Has>
Rgb Path<Has>::radiance_from_outside() const {
  if constexpr (Has.environment) {
    if (!settings_.environment) return check_finite("background", settings_.background, nullptr);
    if (has_environment_) return Rgb(0);
    const EnvironmentMap& map = *settings_.environment;
    if (!(pdf_ > 0 && environment_probability_ > 0)) {
      return check_finite("environment map", map.radiance(ray_.direction), nullptr);
    }
    const EnvironmentMap::RadianceAndPdf there = map.radiance_and_pdf(from_normal_, ray_.direction);
    const float weight = power_heuristic(pdf_, environment_probability_ * there.pdf);
    check_finite("environment map's weight", weight, nullptr);
    return check_finite("environment map", there.radiance, nullptr) * weight;
  }
  return check_finite("background", settings_.background, nullptr);
}

template <PathEffects Has>
void Path<Has>::add_direct_light(const ShadingPoint& shading, const Uniform4& xi) {
  if (Has.needs_general_bsdf && !shading.reflector.has_nonspecular_part()) return;
  if constexpr (Has.environment) {
    if (xi.z < environment_probability_) {
      add_environment_light(shading, xi.xy());
      return;
    }
  }
  if constexpr (Has.area_lights) {
    if (scene_.lights().empty()) return;
    add_area_light(shading, (xi.z - environment_probability_) / (1 - environment_probability_), xi.xy());
  }
}

/// The unshadowed contribution of a light of radiance 1 that was sampled with this pdf, with its MIS weight
/// against BRDF sampling; empty if it is 0.
template <PathEffects Has>
std::optional<Rgb> Path<Has>::unshadowed_contribution(const ShadingPoint& shading, const Vec3f& direction,
                                                      float light_pdf) {
  const Vec3f v = shading.frame.to_local(direction);
  if (v.z <= 0 || !(light_pdf > 0) || !std::isfinite(light_pdf)) return std::nullopt;
  const Reflection reflection = reflect(shading, v);
  check_finite("BRDF's value", reflection.value, &shading.point);
  if (reflectance::is_black(reflection.value)) return std::nullopt;
  light_direction_ = direction;
  const float weight = power_heuristic(light_pdf, static_cast<float>(split_count_) * reflection.pdf);
  check_finite("light's weight", weight, &shading.point);
  return throughput_ * shading.point.colour * reflection.value * (v.z * weight / light_pdf);
}

template <PathEffects Has>
Reflection Path<Has>::reflect(const ShadingPoint& shading, const Vec3f& v) const {
  if constexpr (!Has.needs_general_bsdf) {
    const Diffuse& diffuse = diffuse_of(shading.reflector);
    return {diffuse.evaluate(shading.u, v), diffuse.pdf(shading.u, v)};
  }
  return shading.reflector.reflect(shading.u, v);
}

template <PathEffects Has>
void Path<Has>::add_area_light(const ShadingPoint& shading, float choice, const Vec2f& xi) {
  const auto light = scene_.lights().sample(shading.point.position, shading.frame.z, choice, xi);
  if (!light || !shading.is_above(light->direction)) return;
  // Rounding can put a point on the back of a face in front of the face.
  if (light->emitter == shading.point.emitter) return;
  const auto lit =
      unshadowed_contribution(shading, light->direction, (1 - environment_probability_) * light->pdf);
  if (!lit) return;
  const Vec3f end = offset_towards(light->position, light->error, light->normal, -light->direction);
  const auto ray = shading.ray_to(scene_, end, light->direction, counter_.rays);
  if (!ray) return;
  ++counter_.rays;
  check_finite("radiance of a light", light->radiance, &shading.point);
  Rgb passed = scene_.transmittance_to_end(*ray, light->emitter) * scene_.opacity_at(*light);
  if (reflectance::is_black(passed)) return;
  if constexpr (Has.transmission) passed *= left_after(glass_.inside, ray->direction.length());
  add_reflected(shading, *lit * light->radiance * passed, light->emitter);
}

template <PathEffects Has>
void Path<Has>::add_environment_light(const ShadingPoint& shading, const Vec2f& xi) {
  const auto light = settings_.environment->sample(shading.frame.z, xi);
  if (!light || !shading.is_above(light->direction)) return;
  const auto lit = unshadowed_contribution(shading, light->direction, environment_probability_ * light->pdf);
  if (!lit) return;
  const auto ray = shading.ray_towards(scene_, light->direction, counter_.rays);
  if (!ray) return;
  ++counter_.rays;
  Rgb passed = scene_.transmittance(*ray);
  if (reflectance::is_black(passed)) return;
  if constexpr (Has.transmission) passed *= left_outside(glass_.inside);
  add_reflected(shading, *lit * light->radiance * passed, InvalidIndex);
}

// The path continues in a direction of its own, not one of the candidates: a direction chosen by the map's
// light would be a poor sample of indirect light.
template <PathEffects Has>
void Path<Has>::add_resampled_light(const ShadingPoint& shading) {
  const float xi = sampler_.next().x;
  const SampleSet points = sampler_.next_set(settings_.resampling->candidates);
  const auto draw = [&](int j) { return sample(shading, points[j]); };
  const auto radiance = [&](const Vec3f& v) {
    const Vec3f direction = shading.frame.to_world(v);
    return shading.is_above(direction) ? settings_.environment->radiance(direction) : Rgb(0);
  };
  const auto add_if_visible = [&](const Vec3f& v, const Rgb& estimate) {
    const Vec3f direction = shading.frame.to_world(v);
    const auto ray = shading.ray_towards(scene_, direction, counter_.rays);
    if (!ray) return;
    ++counter_.rays;
    Rgb passed = scene_.transmittance(*ray);
    if (reflectance::is_black(passed)) return;
    if constexpr (Has.transmission) passed *= left_outside(glass_.inside);
    check_finite("resampled light", estimate, &shading.point);
    add_reflected(shading, throughput_ * shading.point.colour * estimate * passed, InvalidIndex);
  };
  reflectance::resample(resampler_, *settings_.resampling, xi, draw, radiance, add_if_visible);
}

template <PathEffects Has>
std::optional<ScatterSample> Path<Has>::sample(const ShadingPoint& shading, const Uniform4& xi) {
  if constexpr (!Has.needs_general_bsdf) {
    const auto drawn = diffuse_of(shading.reflector).sample(shading.u, {xi.xy(), xi.z});
    if (!drawn) return std::nullopt;
    return ScatterSample{drawn->direction, drawn->weight, drawn->pdf, false};
  }
  if (!settings_.measures_sampling) return shading.reflector.sample(shading.u, {xi.xy(), xi.z});
  const std::uint64_t start = processor_ticks();
  auto drawn = shading.reflector.sample(shading.u, {xi.xy(), xi.z});
  counter_.sampling_ticks += processor_ticks() - start;
  return drawn;
}

template <PathEffects Has>
bool Path<Has>::scatter(const ShadingPoint& shading, const Uniform4& xi) {
  if constexpr (Has.transmission) {
    if (shading.point.surface->is_glass) return scatter_at_glass(shading, xi.z);
  }
  const auto drawn = sample(shading, xi);
  if (!drawn || (drawn->is_specular && !settings_.reflects_specular)) return false;
  const Vec3f direction = shading.frame.to_world(drawn->direction);
  if (!shading.is_above(direction)) return false;
  check_finite("weight of a sampled direction", drawn->weight, &shading.point);
  throughput_ *= drawn->weight * shading.point.colour;
  if (reflectance::is_black(throughput_)) return false;
  return leave(shading, direction, drawn->is_specular ? 0 : static_cast<float>(split_count_) * drawn->pdf);
}

/// Leaves a surface in a direction above it that was drawn with this pdf; 0 for specular reflection.
template <PathEffects Has>
bool Path<Has>::leave(const ShadingPoint& shading, const Vec3f& direction, float pdf) {
  if constexpr (Has.observe) from_reflector_ = shading.point.surface->reflector;
  pdf_ = pdf;
  from_ = shading.point.position;
  from_normal_ = shading.frame.z;
  const auto ray = shading.ray_towards(scene_, direction, counter_.rays);
  if (!ray) return false;
  ray_ = *ray;
  if (pdf_ > 0) {
    ray_.cone = ray_.cone.widened(pdf_);
    takes_irradiance_ = false;
    was_scattered_ = true;
  }
  return true;
}

template <PathEffects Has>
bool Path<Has>::scatter_at_glass(const ShadingPoint& shading, float xi) {
  const auto step = step_at_glass(shading, ray_.direction, settings_.reflects_specular, xi, glass_);
  if (!step) return false;
  check_finite("weight of a sampled direction", step->weight, &shading.point);
  throughput_ *= step->weight * shading.point.colour;
  if (reflectance::is_black(throughput_)) return false;
  if (!step->passed) {
    const Vec3f direction = shading.frame.to_world(reflectance::mirrored(shading.u));
    return shading.is_above(direction) && leave(shading, direction, 0);
  }
  if constexpr (Has.observe) from_reflector_ = shading.point.surface->reflector;
  pdf_ = 0;
  ray_ = *step->passed;
  return true;
}

/// Returns the point that the path meets next, behind the panes that it passes.
template <PathEffects Has>
std::optional<SurfacePoint> Path<Has>::next_point() {
  const auto cast = [&] {
    ++counter_.rays;
    return scene_.intersect(ray_, scene_.has_cutouts() ? sampler_.word() : 0);
  };
  if constexpr (!Has.transmission) {
    return cast();  // without a copy of the point
  } else {
    for (;;) {
      auto point = cast();
      throughput_ *= left_on_way(glass_.inside, ray_, point);
      if (!point || !point->surface->is_pane) return point;
      const reflectance::Glass& pane = glass_of(*scene_.reflector(*point->surface));
      const auto factor = pass_pane(pane, *point, settings_.reflects_specular, sampler_.word(), ray_, glass_);
      if (!factor) return point;
      add_emission(*point);
      throughput_ *= *factor;
    }
  }
}

// Russian roulette, only for paths whose throughput is below a third: ending others costs more error than it
// saves time.
template <PathEffects Has>
bool Path<Has>::survives(float xi) {
  const float survival = 3 * reflectance::largest(throughput_);
  if (survival >= 1) return true;
  if (xi >= survival) return false;
  throughput_ /= survival;
  return true;
}

// Baked irradiance determines only what a diffuse surface reflects, and only on its front: the back of a wall
// receives other light.
template <PathEffects Has>
bool Path<Has>::has_irradiance(const SurfacePoint& point, const Reflector& reflector) const {
  return takes_irradiance_ && point.irradiance && ray_.direction.dot(point.geometric_normal) < 0 &&
         !reflectance::has_glossy_part(reflector.brdf()) && !reflectance::has_specular_part(reflector.brdf());
}

template <PathEffects Has>
GatherSample Path<Has>::gather(const ShadingPoint& shading) {
  may_split_ = false;
  const SamplePair xi = sampler_.next_two();
  add_direct_light(shading, xi.first);
  GatherSample gathered{{light_direction_, std::exchange(radiance_, Rgb(0))}, {}};
  if (scatter(shading, xi.second)) {
    gathered.scattered.direction = ray_.direction;
    gathered.scattered.radiance = run(std::nullopt, 1);
  }
  return gathered;
}

/// The mean of several paths from a hit, which share the path before it and its light sample.
template <PathEffects Has>
Rgb Path<Has>::split(const ShadingPoint& shading, int bounces) {
  may_split_ = false;
  const SampleSet points = sampler_.next_set(split_count_);
  Rgb sum(0);
  for (int i = 0; i < split_count_; ++i) {
    Path branch(*this);
    branch.radiance_ = Rgb(0);
    if constexpr (Has.observe) branch.fraction_ = fraction_ / static_cast<float>(split_count_);
    branch.sampler_ = sampler_.branch(i, split_count_);
    const Uniform4 xi = points[i];
    if (branch.scatter(shading, xi) && branch.survives(xi.w)) sum += branch.run(std::nullopt, bounces);
  }
  return sum / static_cast<float>(split_count_);
}

template <PathEffects Has>
Rgb Path<Has>::run(const std::optional<Rgb>& backplate, int bounces) {
  for (;; ++bounces) {
    if constexpr (Has.observe) bounces_ = bounces;
    const auto point = next_point();
    if (!point) {
      const Rgb outside = backplate && bounces == 0 ? check_finite("backplate", *backplate, nullptr)
                                                    : radiance_from_outside();
      add(throughput_ * outside, InvalidIndex, from_reflector_, bounces);
      return radiance_;
    }
    add_emission(*point);
    check_finite("colour", point->colour, &*point);
    if (point->surface->reflector == InvalidIndex || bounces >= settings_.depth) return radiance_;
    std::optional<Reflector> varied;
    const Reflector* reflector =
        Has.varying_brdfs ? scene_.reflector_at(*point, varied) : scene_.reflector(*point->surface);
    if (was_scattered_ && !point->surface->interreflects) return radiance_;
    const ShadingPoint shading(*point, *reflector, -ray_.direction);
    if (has_irradiance(*point, *reflector)) {
      const Rgb value = reflector->evaluate(shading.u, Vec3f(0, 0, 1));
      check_finite("BRDF's value", value, &*point);
      check_finite("irradiance", *point->irradiance, &*point);
      add_reflected(shading, throughput_ * point->colour * value * *point->irradiance, InvalidIndex);
      return radiance_;
    }
    // Where only direct light can follow, one direction suffices.
    const bool splits = settings_.split_count > 1 && may_split_ && reflector->has_nonspecular_part() &&
                        bounces + 1 < settings_.depth;
    split_count_ = splits ? settings_.split_count : 1;
    // From here on, the path collects light of `depth` bounces alone.
    if (bounces + 1 == settings_.depth) throughput_ *= settings_.last_bounce_factor;
    const SamplePair xi = sampler_.next_two();
    add_direct_light(shading, xi.first);
    if constexpr (Has.resampling) {
      // A specular surface's candidates would all be the same.
      has_environment_ = resamples_ && reflector->has_nonspecular_part();
      if (has_environment_) add_resampled_light(shading);
    }
    if (splits) return radiance_ + split(shading, bounces + 1);
    if (!scatter(shading, xi.second) || !survives(xi.second.w)) return radiance_;
  }
}

template <PathEffects Has>
Rgb path_radiance(const CompiledScene& scene, const IntegratorSettings& settings, const Ray& ray,
                  const std::optional<Rgb>& backplate, PathSampler& sampler, RayCounter& counter) {
  return Path<Has>(scene, settings, ray, sampler, counter).run(backplate);
}

template <PathEffects Has>
GatherSample path_gathered(const CompiledScene& scene, const IntegratorSettings& settings,
                           const ShadingPoint& shading, PathSampler& sampler, RayCounter& counter) {
  return Path<Has>(scene, settings, Ray(), sampler, counter).gather(shading);
}

struct PathKernel {
  PathEffects effects;
  Kernel kernel;
  GatherKernel gather_kernel;
};

template <PathEffects Has>
constexpr PathKernel kernel_with() {
  return {Has, &path_radiance<Has>, &path_gathered<Has>};
}

constexpr PathEffects DiffuseUnderLights = {.area_lights = true,
                                            .environment = false,
                                            .resampling = false,
                                            .needs_general_bsdf = false,
                                            .transmission = false,
                                            .varying_brdfs = false};
constexpr PathEffects UnderLights = {.area_lights = true,
                                     .environment = false,
                                     .resampling = false,
                                     .transmission = false,
                                     .varying_brdfs = false};
constexpr PathEffects UnderEnvironment = {
    .area_lights = false, .resampling = false, .transmission = false, .varying_brdfs = false};
constexpr PathEffects Opaque = {.transmission = false, .varying_brdfs = false};
constexpr PathEffects All;

/// From the cheapest to the most general.
constexpr std::array Kernels = {kernel_with<DiffuseUnderLights>(), kernel_with<UnderLights>(),
                                kernel_with<UnderEnvironment>(), kernel_with<Opaque>(), kernel_with<All>()};

constexpr PathEffects Observing = {.observe = true};

const PathKernel& kernel_for(const PathEffects& effects) {
  for (const PathKernel& candidate : Kernels) {
    if (candidate.effects.cover(effects)) return candidate;
  }
  return Kernels.back();
}

}  // namespace

Kernel path_kernel(const PathEffects& effects) { return kernel_for(effects).kernel; }

Kernel observing_path_kernel() { return &path_radiance<Observing>; }

GatherKernel gather_kernel(const PathEffects& effects) { return kernel_for(effects).gather_kernel; }

}  // namespace transport
