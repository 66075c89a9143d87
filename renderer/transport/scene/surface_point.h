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
  /// False if it reflects nothing to paths that were scattered before, other than by mirrors.
  bool interreflects = true;
  /// Where there are no uv, the tangent is the cross product of this and the normal: the y axis of the
  /// object, transformed as normals are, so that tangents run round it like parallels round the earth.
  Vec3f axis = Vec3f(0, 1, 0);

  bool operator==(const CompiledSurface&) const = default;
};

/// Where a ray met a surface, in the coordinates of the compiled scene.
///
/// Where interpolated normals make a surface appear to bulge, `rise` leads to where that surface would be
/// (Hanika 2021, "Hacking the shadow terminator", Ray tracing gems II, chapter 4). Directions that are above
/// that surface's horizon but not above the triangle's leave from there: what is lit then ends as softly as
/// on the surface that the triangles stand for. See CompiledScene::start_of.
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
  RayCone cone;                   ///< of the ray that met it
  Vec3f rise = Vec3f(0);          ///< 0 where the surface does not seem to be above the triangle
  std::optional<Rgb> irradiance;  ///< W/m2, if the scene was compiled with it and all corners have it

  /// Where rays in this direction start that leave the triangle.
  Vec3f origin_towards(const Vec3f& direction) const {
    return offset_towards(position, error, geometric_normal, direction);
  }
};

/// Where a ray starts.
struct RayStart {
  Vec3f origin;
  TriangleId from;  ///< which it cannot meet
};

}  // namespace transport
