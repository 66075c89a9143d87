#include "renderer/transport/path.h"

#include <cmath>

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
        frame(shading_normal(back)),
        u(frame.to_local(back)) {}

  /// Light passes through no surface, whatever an interpolated normal says.
  bool is_above(const Vec3f& world_direction) const { return world_direction.dot(geometric_normal) > 0; }

 private:
  // An interpolated normal that points away from the eye would make the surface black: the true one serves.
  Vec3f shading_normal(const Vec3f& back) const {
    const bool flipped = back.dot(point.geometric_normal) < 0;
    const Vec3f normal = flipped ? -point.shading_normal : point.shading_normal;
    return normal.dot(back) > 0 ? normal : geometric_normal;
  }
};

/// The path so far.
struct Path {
  const CompiledScene& scene;
  const PathSettings& settings;
  PathNumbers& numbers;
  RayCounter& counter;
  Ray ray;
  Rgb throughput = Rgb(1);
  Rgb radiance = Rgb(0);
  /// The solid-angle density with which the ray was drawn, where a light could have been sampled instead;
  /// 0 for camera rays and mirror directions.
  float density = 0;

  void add_emission(const SurfacePoint& point);
  void add_direct_light(const Scattering& scattering, const Uniform4& xi);
  bool scatter(const Scattering& scattering, const Uniform4& xi);
  Rgb run();
};

/// Turns a density per area into one per solid angle, seen over a vector from the point that is lit.
float to_solid_angle(float area_density, const Vec3f& to_light, const Vec3f& light_normal) {
  const float distance2 = to_light.length2();
  const float cosine = std::abs(to_light.dot(light_normal)) / std::sqrt(distance2);
  return area_density * distance2 / cosine;
}

void Path::add_emission(const SurfacePoint& point) {
  const Rgb& emission = point.surface->emission;
  if (reflectance::is_black(emission) || ray.direction.dot(point.geometric_normal) >= 0) return;
  float weight = 1;
  if (density > 0 && point.emitter != None) {
    const float area_density = scene.emitters().area_density(point.emitter);
    weight = power_heuristic(
        density, to_solid_angle(area_density, point.position - ray.origin, point.geometric_normal));
  }
  radiance += throughput * emission * weight;
}

void Path::add_direct_light(const Scattering& scattering, const Uniform4& xi) {
  if (scene.emitters().empty() || !scattering.reflector.has_density()) return;
  const LightSample light = scene.emitters().sample(xi.z, xi.xy());
  const Vec3f to_light = light.position - scattering.point.position;
  if (to_light.dot(light.normal) >= 0 || !scattering.is_above(to_light)) return;
  const Vec3f direction = to_light.normalized();
  const Vec3f v = scattering.frame.to_local(direction);
  if (v.z <= 0) return;
  const Rgb reflected = scattering.reflector.evaluate(scattering.u, v) * v.z;
  if (reflectance::is_black(reflected)) return;
  const float light_density = to_solid_angle(light.density, to_light, light.normal);
  if (!(light_density > 0) || !std::isfinite(light_density)) return;
  const float weight = power_heuristic(light_density, scattering.reflector.density(scattering.u, v));
  const Vec3f origin = scattering.point.origin_towards(direction);
  const Vec3f end = offset_towards(light.position, light.error, light.normal, -direction);
  ++counter.rays;
  if (scene.is_occluded({origin, end - origin})) return;
  radiance += throughput * scattering.point.colour * reflected * light.radiance * (weight / light_density);
}

bool Path::scatter(const Scattering& scattering, const Uniform4& xi) {
  const auto sample = scattering.reflector.sample(scattering.u, {xi.xy(), xi.z});
  if (!sample) return false;
  const Vec3f direction = scattering.frame.to_world(sample->direction);
  if (!scattering.is_above(direction)) return false;
  throughput *= sample->weight * scattering.point.colour;
  if (reflectance::is_black(throughput)) return false;
  density = sample->is_mirror ? 0 : sample->density;
  ray = {scattering.point.origin_towards(direction), direction};
  return true;
}

Rgb Path::run() {
  for (int events = 0;; ++events) {
    ++counter.rays;
    const auto point = scene.intersect(ray);
    if (!point) return radiance + throughput * settings.background;
    add_emission(*point);
    const Reflector* reflector = scene.reflector(*point->surface);
    if (reflector == nullptr || events >= settings.depth) return radiance;
    const Scattering scattering(*point, *reflector, -ray.direction);
    add_direct_light(scattering, numbers.next());
    if (!scatter(scattering, numbers.next())) return radiance;
  }
}

}  // namespace

Rgb path_radiance(const CompiledScene& scene, const PathSettings& settings, const Ray& ray,
                  PathNumbers& numbers, RayCounter& counter) {
  return Path{scene, settings, numbers, counter, ray}.run();
}

}  // namespace transport
