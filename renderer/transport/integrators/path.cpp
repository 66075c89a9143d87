#include "renderer/transport/integrators/path.h"

#include <cmath>

#include "renderer/transport/processor_clock.h"

namespace transport {
namespace {

using reflectance::Frame;
using reflectance::Reflector;

float power_heuristic(float density, float other) {
  // In terms of the ratio, which overflows to a right answer where squares would not.
  const float ratio = other / density;
  return 1 / (1 + ratio * ratio);
}

/// A surface as the path sees it: turned to the side that it came from.
struct Scattering {
  const SurfacePoint& point;
  const Reflector& reflector;
  Vec3f geometric_normal;
  Frame frame;
  Vec3f u;  ///< towards where the path came from, local

  Scattering(const SurfacePoint& surface_point, const Reflector& surface_reflector, const Vec3f& back)
      : point(surface_point),
        reflector(surface_reflector),
        geometric_normal(back.dot(point.geometric_normal) < 0 ? -point.geometric_normal
                                                              : point.geometric_normal),
        frame(shading_normal(back), point.tangent),
        u(frame.to_local(back)) {}

  /// Light passes through no surface, whatever an interpolated normal says.
  bool is_above(const Vec3f& world_direction) const {
    return point.is_above(world_direction, geometric_normal, frame.z);
  }

 private:
  // An interpolated normal that points away from the eye would make the surface black: the true one serves.
  Vec3f shading_normal(const Vec3f& back) const {
    const bool flipped = back.dot(point.geometric_normal) < 0;
    const Vec3f normal = flipped ? -point.shading_normal : point.shading_normal;
    return normal.dot(back) > 0 ? normal : geometric_normal;
  }
};

/// The path so far.
class Path {
 public:
  Path(const CompiledScene& scene, const PathSettings& settings, const Ray& ray, PathNumbers& numbers,
       RayCounter& counter)
      : scene_(scene), settings_(settings), numbers_(numbers), counter_(counter), ray_(ray) {
    const bool has_environment = settings.environment && !settings.environment->is_black();
    if (has_environment && !settings.resampling) environment_share_ = scene.emitters().empty() ? 1 : 0.5F;
    resamples_ = has_environment && settings.resampling;
  }

  Rgb run(const std::optional<Rgb>& behind);

 private:
  Rgb radiance_from_outside() const;
  void add_emission(const SurfacePoint& point);
  void add_direct_light(const Scattering& scattering, const Uniform4& xi);
  void add_area_light(const Scattering& scattering, float choice, const Vec2f& xi);
  void add_environment_light(const Scattering& scattering, const Vec2f& xi);
  void add_resampled_light(const Scattering& scattering);
  std::optional<Rgb> lit_from(const Scattering& scattering, const Vec3f& direction,
                              float light_density) const;
  std::optional<reflectance::ScatterSample> sample(const Scattering& scattering, const Uniform4& xi);
  bool scatter(const Scattering& scattering, const Uniform4& xi);

  const CompiledScene& scene_;
  const PathSettings& settings_;
  PathNumbers& numbers_;
  RayCounter& counter_;
  Ray ray_;
  Rgb throughput_ = Rgb(1);
  Rgb radiance_ = Rgb(0);
  /// The solid-angle density with which the ray was drawn, where a light could have been sampled instead;
  /// 0 for camera rays and mirror directions.
  float density_ = 0;
  float environment_share_ = 0;  ///< the probability of sampling the map and not an emitter
  bool resamples_ = false;
  reflectance::Resampler resampler_;
  /// The map's light along the ray was added where the ray starts.
  bool has_environment_ = false;
};

/// Turns a density per area into one per solid angle, seen over a vector from the point that is lit.
float to_solid_angle(float area_density, const Vec3f& to_light, const Vec3f& light_normal) {
  const float distance2 = to_light.length2();
  const float cosine = std::abs(to_light.dot(light_normal)) / std::sqrt(distance2);
  return area_density * distance2 / cosine;
}

void Path::add_emission(const SurfacePoint& point) {
  const Rgb& emission = point.surface->emission;
  if (reflectance::is_black(emission) || ray_.direction.dot(point.geometric_normal) >= 0) return;
  float weight = 1;
  if (density_ > 0 && point.emitter != None) {
    const float area_density = (1 - environment_share_) * scene_.emitters().area_density(point.emitter);
    weight = power_heuristic(
        density_, to_solid_angle(area_density, point.position - ray_.origin, point.geometric_normal));
  }
  radiance_ += throughput_ * emission * weight;
}

Rgb Path::radiance_from_outside() const {
  if (!settings_.environment) return settings_.background;
  if (has_environment_) return Rgb(0);
  float weight = 1;
  if (density_ > 0 && environment_share_ > 0) {
    weight = power_heuristic(density_, environment_share_ * settings_.environment->density(ray_.direction));
  }
  return settings_.environment->radiance(ray_.direction) * weight;
}

void Path::add_direct_light(const Scattering& scattering, const Uniform4& xi) {
  if (!scattering.reflector.has_density()) return;
  if (xi.z < environment_share_) {
    add_environment_light(scattering, xi.xy());
  } else if (!scene_.emitters().empty()) {
    add_area_light(scattering, (xi.z - environment_share_) / (1 - environment_share_), xi.xy());
  }
}

/// What a light of radiance 1 that was sampled with this density adds, weighted against the BRDF's own
/// sampling; nothing if that is 0.
std::optional<Rgb> Path::lit_from(const Scattering& scattering, const Vec3f& direction,
                                  float light_density) const {
  const Vec3f v = scattering.frame.to_local(direction);
  if (v.z <= 0 || !(light_density > 0) || !std::isfinite(light_density)) return std::nullopt;
  const Rgb reflected = scattering.reflector.evaluate(scattering.u, v) * v.z;
  if (reflectance::is_black(reflected)) return std::nullopt;
  const float weight = power_heuristic(light_density, scattering.reflector.density(scattering.u, v));
  return throughput_ * scattering.point.colour * reflected * (weight / light_density);
}

void Path::add_area_light(const Scattering& scattering, float choice, const Vec2f& xi) {
  const LightSample light = scene_.emitters().sample(choice, xi);
  const Vec3f to_light = light.position - scattering.point.position;
  if (to_light.dot(light.normal) >= 0 || !scattering.is_above(to_light)) return;
  const Vec3f direction = to_light.normalized();
  const float area_density = (1 - environment_share_) * light.density;
  const auto lit = lit_from(scattering, direction, to_solid_angle(area_density, to_light, light.normal));
  if (!lit) return;
  const Vec3f end = offset_towards(light.position, light.error, light.normal, -direction);
  ++counter_.rays;
  if (!scene_.is_occluded(scattering.point.ray_to(end, direction), light.emitter))
    radiance_ += *lit * light.radiance;
}

void Path::add_environment_light(const Scattering& scattering, const Vec2f& xi) {
  const auto light = settings_.environment->sample(xi);
  if (!light || !scattering.is_above(light->direction)) return;
  const auto lit = lit_from(scattering, light->direction, environment_share_ * light->density);
  if (!lit) return;
  ++counter_.rays;
  if (scene_.escapes(scattering.point.ray_towards(light->direction))) {
    radiance_ += *lit * light->radiance;
  }
}

// Besides the candidates, the path goes on with a direction of its own: one that was chosen by the map's
// light would be a poor one for what comes from other surfaces.
void Path::add_resampled_light(const Scattering& scattering) {
  const float xi = numbers_.next().x;
  const PointSet points = numbers_.next_set(settings_.resampling->candidates);
  const auto draw = [&](int j) { return sample(scattering, points[j]); };
  const auto radiance = [&](const Vec3f& v) {
    const Vec3f direction = scattering.frame.to_world(v);
    return scattering.is_above(direction) ? settings_.environment->radiance(direction) : Rgb(0);
  };
  const auto add_if_visible = [&](const Vec3f& v, const Rgb& estimate) {
    const Vec3f direction = scattering.frame.to_world(v);
    ++counter_.rays;
    if (!scene_.escapes(scattering.point.ray_towards(direction))) return;
    radiance_ += throughput_ * scattering.point.colour * estimate;
  };
  reflectance::resample(resampler_, *settings_.resampling, xi, draw, radiance, add_if_visible);
}

std::optional<reflectance::ScatterSample> Path::sample(const Scattering& scattering, const Uniform4& xi) {
  if (!settings_.measures_sampling) return scattering.reflector.sample(scattering.u, {xi.xy(), xi.z});
  const std::uint64_t start = processor_ticks();
  const auto drawn = scattering.reflector.sample(scattering.u, {xi.xy(), xi.z});
  counter_.sampling_ticks += processor_ticks() - start;
  return drawn;
}

bool Path::scatter(const Scattering& scattering, const Uniform4& xi) {
  const auto drawn = sample(scattering, xi);
  if (!drawn) return false;
  const Vec3f direction = scattering.frame.to_world(drawn->direction);
  if (!scattering.is_above(direction)) return false;
  throughput_ *= drawn->weight * scattering.point.colour;
  if (reflectance::is_black(throughput_)) return false;
  density_ = drawn->is_mirror ? 0 : drawn->density;
  ray_ = scattering.point.ray_towards(direction);
  if (density_ > 0) ray_.cone = ray_.cone.widened(density_);
  return true;
}

Rgb Path::run(const std::optional<Rgb>& behind) {
  for (int events = 0;; ++events) {
    ++counter_.rays;
    const auto point = scene_.intersect(ray_);
    if (!point) {
      return radiance_ + throughput_ * (behind && events == 0 ? *behind : radiance_from_outside());
    }
    add_emission(*point);
    const Reflector* reflector = scene_.reflector(*point->surface);
    if (reflector == nullptr || events >= settings_.depth) return radiance_;
    const Scattering scattering(*point, *reflector, -ray_.direction);
    add_direct_light(scattering, numbers_.next());
    // A mirror's candidates would all be the same one.
    has_environment_ = resamples_ && reflector->has_density();
    if (has_environment_) add_resampled_light(scattering);
    if (!scatter(scattering, numbers_.next())) return radiance_;
  }
}

}  // namespace

Rgb path_radiance(const CompiledScene& scene, const PathSettings& settings, const Ray& ray,
                  const std::optional<Rgb>& behind, PathNumbers& numbers, RayCounter& counter) {
  return Path(scene, settings, ray, numbers, counter).run(behind);
}

}  // namespace transport
