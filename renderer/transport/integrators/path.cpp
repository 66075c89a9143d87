#include "renderer/transport/integrators/path.h"

#include <array>
#include <cmath>
#include <string_view>
#include <utility>
#include <variant>

#include "renderer/transport/integrators/power_heuristic.h"
#include "renderer/transport/integrators/scattering.h"
#include "renderer/transport/lights/environment_share.h"
#include "renderer/transport/processor_clock.h"

namespace transport {
namespace {

using reflectance::Diffuse;
using reflectance::Reflection;
using reflectance::Reflector;
using reflectance::ScatterSample;

const Diffuse& matte_of(const Reflector& reflector) { return *std::get_if<Diffuse>(&reflector.brdf()); }

/// A path, advanced bounce by bounce.
template <PathEffects Has>
class Path {
 public:
  Path(const CompiledScene& scene, const IntegratorSettings& settings, const Ray& ray,
       const PathNumbers& numbers, RayCounter& counter)
      : scene_(scene), settings_(settings), numbers_(numbers), counter_(counter), ray_(ray) {
    if constexpr (Has.environment) {
      resamples_ = settings.resampling && settings.environment && !settings.environment->is_black();
      if (!resamples_) {
        environment_share_ = environment_share(settings.environment.get(), scene.lights(), scene.bounds());
      }
    }
  }

  /// Continues after `events` bounces.
  Rgb run(const std::optional<Rgb>& behind, int events = 0);
  /// Starts with a bounce off a white diffuse surface instead of a camera ray.
  Gathered gather(const Scattering& scattering);

 private:
  template <class Value>
  const Value& seen(std::string_view term, const Value& value, const SurfacePoint* where) const;
  Rgb radiance_from_outside() const;
  void add_emission(const SurfacePoint& point);
  void add_direct_light(const Scattering& scattering, const Uniform4& xi);
  void add_area_light(const Scattering& scattering, float choice, const Vec2f& xi);
  void add_environment_light(const Scattering& scattering, const Vec2f& xi);
  void add_resampled_light(const Scattering& scattering);
  std::optional<Rgb> lit_from(const Scattering& scattering, const Vec3f& direction, float light_density);
  Reflection reflect(const Scattering& scattering, const Vec3f& v) const;
  std::optional<ScatterSample> sample(const Scattering& scattering, const Uniform4& xi);
  bool scatter(const Scattering& scattering, const Uniform4& xi);
  bool has_irradiance(const SurfacePoint& point, const Reflector& reflector) const;
  bool survives(float xi);
  Rgb split(const Scattering& scattering, int events);

  const CompiledScene& scene_;
  const IntegratorSettings& settings_;
  PathNumbers numbers_;
  RayCounter& counter_;
  Ray ray_;
  Rgb throughput_ = Rgb(1);
  Rgb radiance_ = Rgb(0);
  /// The solid-angle pdf of the ray, summed over all split paths, where a light could have been sampled
  /// instead; 0 for camera rays and specular directions.
  float density_ = 0;
  /// The point that the ray was scattered from, with its shading normal.
  Vec3f from_, from_normal_;
  float environment_share_ = 0;  ///< the probability of sampling the environment map rather than an emitter
  bool resamples_ = false;
  reflectance::Resampler resampler_;
  /// The environment's light along the ray was already added at its origin.
  bool has_environment_ = false;
  /// So far all hits were specular, and baked irradiance can be used.
  bool takes_irradiance_ = settings_.uses_irradiance;
  bool was_scattered_ = false;        ///< by a non-specular bounce
  bool may_split_ = true;             ///< no non-specular hit yet
  int ways_ = 1;                      ///< number of paths that continue from this hit
  Vec3f light_direction_ = Vec3f(0);  ///< to the last light sample that could be reflected
};

/// Returns the value; a checking kernel records the first one that is not finite.
template <PathEffects Has>
template <class Value>
const Value& Path<Has>::seen(std::string_view term, const Value& value, const SurfacePoint* where) const {
  if constexpr (Has.search) counter_.note_unless_finite(term, value, where);
  return value;
}

template <PathEffects Has>
void Path<Has>::add_emission(const SurfacePoint& point) {
  const Rgb& emission = seen("emission", point.surface->emission, &point);
  if (reflectance::is_black(emission) || ray_.direction.dot(point.geometric_normal) >= 0) return;
  float weight = 1;
  if (density_ > 0 && point.emitter != None) {
    const float light_density = scene_.lights().density(from_, from_normal_, point.emitter, ray_.direction);
    weight = power_heuristic(density_, (1 - environment_share_) * light_density);
    seen("emission's weight", weight, &point);
  }
  radiance_ += throughput_ * emission * weight;
}

template <PathEffects Has>
Rgb Path<Has>::radiance_from_outside() const {
  if constexpr (Has.environment) {
    if (!settings_.environment) return seen("background", settings_.background, nullptr);
    if (has_environment_) return Rgb(0);
    const EnvironmentMap& map = *settings_.environment;
    if (!(density_ > 0 && environment_share_ > 0)) {
      return seen("environment map", map.radiance(ray_.direction), nullptr);
    }
    const EnvironmentMap::Seen there = map.seen(from_normal_, ray_.direction);
    const float weight = power_heuristic(density_, environment_share_ * there.density);
    seen("environment map's weight", weight, nullptr);
    return seen("environment map", there.radiance, nullptr) * weight;
  }
  return seen("background", settings_.background, nullptr);
}

template <PathEffects Has>
void Path<Has>::add_direct_light(const Scattering& scattering, const Uniform4& xi) {
  if (Has.other_than_matte && !scattering.reflector.has_density()) return;
  if constexpr (Has.environment) {
    if (xi.z < environment_share_) {
      add_environment_light(scattering, xi.xy());
      return;
    }
  }
  if constexpr (Has.area_lights) {
    if (scene_.lights().empty()) return;
    add_area_light(scattering, (xi.z - environment_share_) / (1 - environment_share_), xi.xy());
  }
}

/// The unshadowed contribution of a light of radiance 1 that was sampled with this pdf, with its MIS weight
/// against BRDF sampling; empty if it is 0.
template <PathEffects Has>
std::optional<Rgb> Path<Has>::lit_from(const Scattering& scattering, const Vec3f& direction,
                                       float light_density) {
  const Vec3f v = scattering.frame.to_local(direction);
  if (v.z <= 0 || !(light_density > 0) || !std::isfinite(light_density)) return std::nullopt;
  const Reflection reflection = reflect(scattering, v);
  seen("BRDF's value", reflection.value, &scattering.point);
  if (reflectance::is_black(reflection.value)) return std::nullopt;
  light_direction_ = direction;
  const float weight = power_heuristic(light_density, static_cast<float>(ways_) * reflection.density);
  seen("light's weight", weight, &scattering.point);
  return throughput_ * scattering.point.colour * reflection.value * (v.z * weight / light_density);
}

template <PathEffects Has>
Reflection Path<Has>::reflect(const Scattering& scattering, const Vec3f& v) const {
  if constexpr (!Has.other_than_matte) {
    const Diffuse& matte = matte_of(scattering.reflector);
    return {matte.evaluate(scattering.u, v), matte.density(scattering.u, v)};
  }
  return scattering.reflector.reflect(scattering.u, v);
}

template <PathEffects Has>
void Path<Has>::add_area_light(const Scattering& scattering, float choice, const Vec2f& xi) {
  const auto light = scene_.lights().sample(scattering.point.position, scattering.frame.z, choice, xi);
  if (!light || !scattering.is_above(light->direction)) return;
  // Rounding can put a point on the back of a face in front of the face.
  if (light->emitter == scattering.point.emitter) return;
  const auto lit = lit_from(scattering, light->direction, (1 - environment_share_) * light->density);
  if (!lit) return;
  const Vec3f end = offset_towards(light->position, light->error, light->normal, -light->direction);
  const auto ray = scattering.ray_to(scene_, end, light->direction, counter_.rays);
  if (!ray) return;
  ++counter_.rays;
  seen("radiance of a light", light->radiance, &scattering.point);
  if (!scene_.is_occluded(*ray, light->emitter)) radiance_ += *lit * light->radiance;
}

template <PathEffects Has>
void Path<Has>::add_environment_light(const Scattering& scattering, const Vec2f& xi) {
  const auto light = settings_.environment->sample(scattering.frame.z, xi);
  if (!light || !scattering.is_above(light->direction)) return;
  const auto lit = lit_from(scattering, light->direction, environment_share_ * light->density);
  if (!lit) return;
  const auto ray = scattering.ray_towards(scene_, light->direction, counter_.rays);
  if (!ray) return;
  ++counter_.rays;
  if (scene_.escapes(*ray)) radiance_ += *lit * light->radiance;
}

// The path continues in a direction of its own, not one of the candidates: a direction chosen by the map's
// light would be a poor sample of indirect light.
template <PathEffects Has>
void Path<Has>::add_resampled_light(const Scattering& scattering) {
  const float xi = numbers_.next().x;
  const PointSet points = numbers_.next_set(settings_.resampling->candidates);
  const auto draw = [&](int j) { return sample(scattering, points[j]); };
  const auto radiance = [&](const Vec3f& v) {
    const Vec3f direction = scattering.frame.to_world(v);
    return scattering.is_above(direction) ? settings_.environment->radiance(direction) : Rgb(0);
  };
  const auto add_if_visible = [&](const Vec3f& v, const Rgb& estimate) {
    const Vec3f direction = scattering.frame.to_world(v);
    const auto ray = scattering.ray_towards(scene_, direction, counter_.rays);
    if (!ray) return;
    ++counter_.rays;
    if (!scene_.escapes(*ray)) return;
    seen("resampled light", estimate, &scattering.point);
    radiance_ += throughput_ * scattering.point.colour * estimate;
  };
  reflectance::resample(resampler_, *settings_.resampling, xi, draw, radiance, add_if_visible);
}

template <PathEffects Has>
std::optional<ScatterSample> Path<Has>::sample(const Scattering& scattering, const Uniform4& xi) {
  if constexpr (!Has.other_than_matte) {
    const auto drawn = matte_of(scattering.reflector).sample(scattering.u, {xi.xy(), xi.z});
    if (!drawn) return std::nullopt;
    return ScatterSample{drawn->direction, drawn->weight, drawn->density, false};
  }
  if (!settings_.measures_sampling) return scattering.reflector.sample(scattering.u, {xi.xy(), xi.z});
  const std::uint64_t start = processor_ticks();
  auto drawn = scattering.reflector.sample(scattering.u, {xi.xy(), xi.z});
  counter_.sampling_ticks += processor_ticks() - start;
  return drawn;
}

template <PathEffects Has>
bool Path<Has>::scatter(const Scattering& scattering, const Uniform4& xi) {
  const auto drawn = sample(scattering, xi);
  if (!drawn || (drawn->is_mirror && !settings_.reflects_mirrors)) return false;
  const Vec3f direction = scattering.frame.to_world(drawn->direction);
  if (!scattering.is_above(direction)) return false;
  seen("weight of a sampled direction", drawn->weight, &scattering.point);
  throughput_ *= drawn->weight * scattering.point.colour;
  if (reflectance::is_black(throughput_)) return false;
  density_ = drawn->is_mirror ? 0 : static_cast<float>(ways_) * drawn->density;
  from_ = scattering.point.position;
  from_normal_ = scattering.frame.z;
  const auto ray = scattering.ray_towards(scene_, direction, counter_.rays);
  if (!ray) return false;
  ray_ = *ray;
  if (density_ > 0) {
    ray_.cone = ray_.cone.widened(density_);
    takes_irradiance_ = false;
    was_scattered_ = true;
  }
  return true;
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
         !reflectance::has_glossy_part(reflector.brdf()) && !reflectance::has_mirror(reflector.brdf());
}

template <PathEffects Has>
Gathered Path<Has>::gather(const Scattering& scattering) {
  may_split_ = false;
  const TwoPoints xi = numbers_.next_two();
  add_direct_light(scattering, xi.first);
  Gathered gathered{{light_direction_, std::exchange(radiance_, Rgb(0))}, {}};
  if (scatter(scattering, xi.second)) {
    gathered.scattered.direction = ray_.direction;
    gathered.scattered.radiance = run(std::nullopt, 1);
  }
  return gathered;
}

/// The mean of several paths from a hit, which share the path before it and its light sample.
template <PathEffects Has>
Rgb Path<Has>::split(const Scattering& scattering, int events) {
  may_split_ = false;
  const PointSet points = numbers_.next_set(ways_);
  Rgb sum(0);
  for (int i = 0; i < ways_; ++i) {
    Path branch(*this);
    branch.radiance_ = Rgb(0);
    branch.numbers_ = numbers_.branch(i, ways_);
    const Uniform4 xi = points[i];
    if (branch.scatter(scattering, xi) && branch.survives(xi.w)) sum += branch.run(std::nullopt, events);
  }
  return sum / static_cast<float>(ways_);
}

template <PathEffects Has>
Rgb Path<Has>::run(const std::optional<Rgb>& behind, int events) {
  for (;; ++events) {
    ++counter_.rays;
    const auto point = scene_.intersect(ray_);
    if (!point) {
      return radiance_ + throughput_ * (behind && events == 0 ? seen("backplate", *behind, nullptr)
                                                              : radiance_from_outside());
    }
    add_emission(*point);
    seen("colour", point->colour, &*point);
    const Reflector* reflector = scene_.reflector(*point->surface);
    if (reflector == nullptr || events >= settings_.depth) return radiance_;
    if (was_scattered_ && !point->surface->interreflects) return radiance_;
    const Scattering scattering(*point, *reflector, -ray_.direction);
    if (has_irradiance(*point, *reflector)) {
      const Rgb value = reflector->evaluate(scattering.u, Vec3f(0, 0, 1));
      seen("BRDF's value", value, &*point);
      seen("irradiance", *point->irradiance, &*point);
      return radiance_ + throughput_ * point->colour * value * *point->irradiance;
    }
    // Where only direct light can follow, one direction suffices.
    const bool splits =
        settings_.branches > 1 && may_split_ && reflector->has_density() && events + 1 < settings_.depth;
    ways_ = splits ? settings_.branches : 1;
    const TwoPoints xi = numbers_.next_two();
    add_direct_light(scattering, xi.first);
    if constexpr (Has.resampling) {
      // A specular surface's candidates would all be the same.
      has_environment_ = resamples_ && reflector->has_density();
      if (has_environment_) add_resampled_light(scattering);
    }
    if (splits) return radiance_ + split(scattering, events + 1);
    if (!scatter(scattering, xi.second) || !survives(xi.second.w)) return radiance_;
  }
}

template <PathEffects Has>
Rgb path_radiance(const CompiledScene& scene, const IntegratorSettings& settings, const Ray& ray,
                  const std::optional<Rgb>& behind, PathNumbers& numbers, RayCounter& counter) {
  return Path<Has>(scene, settings, ray, numbers, counter).run(behind);
}

template <PathEffects Has>
Gathered path_gathered(const CompiledScene& scene, const IntegratorSettings& settings,
                       const Scattering& scattering, PathNumbers& numbers, RayCounter& counter) {
  return Path<Has>(scene, settings, Ray(), numbers, counter).gather(scattering);
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

constexpr PathEffects MatteUnderLights = {
    .area_lights = true, .environment = false, .resampling = false, .other_than_matte = false};
constexpr PathEffects UnderLights = {.area_lights = true, .environment = false, .resampling = false};
constexpr PathEffects UnderEnvironment = {.area_lights = false, .resampling = false};
constexpr PathEffects All;

/// From the cheapest to the most general.
constexpr std::array Kernels = {kernel_with<MatteUnderLights>(), kernel_with<UnderLights>(),
                                kernel_with<UnderEnvironment>(), kernel_with<All>()};

bool covers(const PathEffects& kernel, const PathEffects& wanted) {
  return kernel.area_lights >= wanted.area_lights && kernel.environment >= wanted.environment &&
         kernel.resampling >= wanted.resampling && kernel.other_than_matte >= wanted.other_than_matte;
}

constexpr PathEffects Searching = {.search = true};

const PathKernel& kernel_for(const PathEffects& effects) {
  for (const PathKernel& candidate : Kernels) {
    if (covers(candidate.effects, effects)) return candidate;
  }
  return Kernels.back();
}

}  // namespace

Kernel path_kernel(const PathEffects& effects) { return kernel_for(effects).kernel; }

Kernel searching_path_kernel() { return &path_radiance<Searching>; }

GatherKernel gather_kernel(const PathEffects& effects) { return kernel_for(effects).gather_kernel; }

}  // namespace transport
