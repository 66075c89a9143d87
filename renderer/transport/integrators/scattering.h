#pragma once

#include "renderer/reflectance/reflector.h"
#include "renderer/transport/scene/compiled_scene.h"

namespace transport {

/// A surface as a path sees it: turned to the side that the path came from.
class Scattering {
 public:
  /// `back` is the unit direction to where the path came from.
  Scattering(const SurfacePoint& surface_point, const reflectance::Reflector& surface_reflector,
             const Vec3f& back)
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

  const SurfacePoint& point;
  const reflectance::Reflector& reflector;
  Vec3f geometric_normal;
  reflectance::Frame frame;
  Vec3f u;  ///< to where the path came from, local

 private:
  // An interpolated normal that points away from the eye would make the surface black: the true one serves.
  Vec3f shading_normal(const Vec3f& back) const {
    const bool flipped = back.dot(point.geometric_normal) < 0;
    const Vec3f normal = flipped ? -point.shading_normal : point.shading_normal;
    return normal.dot(back) > 0 ? normal : geometric_normal;
  }
};

}  // namespace transport
