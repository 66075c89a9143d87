#pragma once

#include <optional>

#include "renderer/reflectance/geometry.h"
#include "renderer/transport/scene/ray.h"
#include "renderer/transport/scene/ray_offset.h"

namespace transport {

using reflectance::Rgb;

/// What faces of one placement share.
struct CompiledSurface {
  Rgb colour = Rgb(1);
  Rgb emission = Rgb(0);
  std::uint32_t reflector = None;  ///< None: black
  std::uint32_t texture = None;
  bool is_anisotropic = false;
  /// Where there are no uv, the tangent is the cross product of this and the normal: the y axis of the
  /// object, transformed as normals are, so that tangents run round it like parallels round the earth.
  Vec3f axis = Vec3f(0, 1, 0);

  bool operator==(const CompiledSurface&) const = default;
};

/// Where a ray met a surface, in the coordinates of the compiled scene.
///
/// Where interpolated normals make a surface appear to bulge, the point is raised to where that surface would
/// be, on the side that the ray came from (Hanika 2021, "Hacking the shadow terminator", Ray tracing gems II,
/// chapter 4). Light then leaves it in all directions above the shading normal's horizon, and what is lit
/// ends as softly as on the surface that the triangles stand for. A point is raised only if nothing is
/// between it and its triangle: light does not get through a wall.
struct SurfacePoint {
  Vec3f position;
  Vec3f error;             ///< bounds of the position's rounding error, for each axis
  Vec3f geometric_normal;  ///< unit, on the front
  Vec3f shading_normal;    ///< unit
  /// The direction of increasing u in the texture's plane, not of unit length nor quite orthogonal to the
  /// shading normal; 0 where the BRDF is isotropic.
  Vec3f tangent = Vec3f(0);
  Rgb colour;
  const CompiledSurface* surface = nullptr;
  std::uint32_t emitter = None;
  TriangleId id;
  RayCone cone;  ///< of the ray that met it
  bool is_raised = false;
  std::optional<Rgb> irradiance;  ///< W/m2, if the scene was compiled with it and all corners have it

  /// Where rays in this direction start.
  Vec3f origin_towards(const Vec3f& direction) const {
    return is_raised ? position : offset_towards(position, error, geometric_normal, direction);
  }
  Ray ray_towards(const Vec3f& direction) const { return ray(origin_towards(direction), direction); }
  /// To a place in this direction, which is where the ray's parameter is 1.
  Ray ray_to(const Vec3f& end, const Vec3f& direction) const {
    const Vec3f origin = origin_towards(direction);
    return ray(origin, end - origin);
  }
  /// Whether a direction leads away from the surface, on the side of these normals: those of the point, or
  /// both turned round.
  bool is_above(const Vec3f& direction, const Vec3f& geometric_side, const Vec3f& shading_side) const {
    return direction.dot(is_raised ? shading_side : geometric_side) > 0;
  }

 private:
  // From above its own triangle, a ray can go down to it.
  Ray ray(const Vec3f& origin, const Vec3f& direction) const {
    return {origin, direction, is_raised ? TriangleId() : id, cone};
  }
};

}  // namespace transport
