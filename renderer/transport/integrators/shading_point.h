#pragma once

#include "renderer/reflectance/reflector.h"
#include "renderer/transport/scene/compiled_scene.h"

namespace transport {

/// A shading point: a surface point turned to the side that the path came from, with its local frame.
class ShadingPoint {
 public:
  /// `back` is the unit direction to where the path came from.
  ShadingPoint(const SurfacePoint& surface_point, const reflectance::Reflector& surface_reflector,
               const Vec3f& back)
      : point(surface_point),
        reflector(surface_reflector),
        geometric_normal(back.dot(point.geometric_normal) < 0 ? -point.geometric_normal
                                                              : point.geometric_normal),
        frame(shading_normal(back), point.tangent),
        u(frame.to_local(back)) {}

  /// Whether a ray may leave in a world direction: never through the surface, whatever an interpolated normal
  /// says. Where the terminator is offset, `ray_towards` makes the final decision.
  bool is_above(const Vec3f& direction) const {
    return direction.dot(geometric_normal) > 0 ||
           (point.terminator_offset.length2() > 0 && direction.dot(frame.z) > 0);
  }

  /// Returns a ray that leaves in a direction; empty if the surface blocks it. Rays that are cast to find its
  /// origin are added to `rays`.
  std::optional<Ray> ray_towards(const CompiledScene& scene, const Vec3f& direction,
                                 std::uint64_t& rays) const {
    const auto start = scene.start_of(point, direction, geometric_normal, rays);
    if (!start) return std::nullopt;
    return Ray{start->origin, direction, start->from, point.cone};
  }
  /// Returns a ray towards a point in this direction, which it reaches at parameter 1.
  std::optional<Ray> ray_to(const CompiledScene& scene, const Vec3f& end, const Vec3f& direction,
                            std::uint64_t& rays) const {
    const auto start = scene.start_of(point, direction, geometric_normal, rays);
    if (!start) return std::nullopt;
    return Ray{start->origin, end - start->origin, start->from, point.cone};
  }

  const SurfacePoint& point;
  const reflectance::Reflector& reflector;
  Vec3f geometric_normal;
  reflectance::Frame frame;
  Vec3f u;  ///< to where the path came from, local

 private:
  // An interpolated normal that points away from the eye would turn the surface black: use the geometric one.
  Vec3f shading_normal(const Vec3f& back) const {
    const bool flipped = back.dot(point.geometric_normal) < 0;
    const Vec3f normal = flipped ? -point.shading_normal : point.shading_normal;
    return normal.dot(back) > 0 ? normal : geometric_normal;
  }
};

}  // namespace transport
