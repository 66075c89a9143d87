#pragma once

#include <optional>

#include "grf/surface.h"
#include "renderer/reflectance/geometry.h"
#include "renderer/transport/scene/ray.h"
#include "renderer/transport/scene/ray_offset.h"

namespace transport {

using reflectance::Rgb;

/// A surface as compiled for the faces of one placement.
struct CompiledSurface {
  Rgb colour = Rgb(1);
  Rgb emission = Rgb(0);
  std::uint32_t reflector = InvalidIndex;  ///< InvalidIndex: black
  std::uint32_t texture = InvalidIndex;
  /// This is the index of a VaryingSurface where images vary the BRDF, else InvalidIndex.
  std::uint32_t varying = InvalidIndex;
  grf::Opacity opacity;
  std::uint32_t alpha = InvalidIndex;  ///< the texture whose alpha the opacity reads
  bool is_glass = false;               ///< it lets light through by its BRDF
  bool is_pane = false;                ///< likewise, without bending it
  bool is_anisotropic = false;
  /// False if it reflects nothing to paths that were scattered before, except by specular reflection.
  bool interreflects = true;
  /// The tangent without uv is the cross product of this axis and the normal: the y axis of the object,
  /// transformed as normals are, so that tangents follow the parallels of a globe.
  Vec3f axis = Vec3f(0, 1, 0);

  /// Whether some light passes straight on, somewhere or in part.
  bool is_cutout() const { return alpha != InvalidIndex || opacity.value < 1 || is_pane; }

  bool operator==(const CompiledSurface&) const = default;
};

/// A point of a surface that a ray has hit, in the coordinates of the compiled scene.
///
/// Where vertex normals make a surface appear curved, `terminator_offset` is the offset to that curved
/// surface (Hanika 2021, "Hacking the shadow terminator", Ray tracing gems II, chapter 4). Directions above
/// the curved surface's horizon but below the triangle's start from there, so that the shadow terminator is
/// as soft as on the surface that the triangles approximate. See CompiledScene::start_of.
struct SurfacePoint {
  Vec3f position;
  Vec3f error;             ///< bounds of the position's rounding error, per axis
  Vec3f geometric_normal;  ///< unit, on the front
  Vec3f shading_normal;    ///< unit
  /// The direction of increasing u in the tangent plane, neither unit nor exactly orthogonal to the shading
  /// normal; 0 where the BRDF is isotropic.
  Vec3f tangent = Vec3f(0);
  Rgb colour;
  const CompiledSurface* surface = nullptr;
  std::uint32_t emitter = InvalidIndex;
  TriangleId id;
  RayCone cone;                        ///< of the ray that hit it
  Vec3f terminator_offset = Vec3f(0);  ///< 0 where the curved surface is not above the triangle
  // For textures, and set only where images vary the BRDF.
  Vec2f uv = Vec2f(0);
  float uv_footprint = 0;         ///< the width of the footprint in uv coordinates
  std::optional<Rgb> irradiance;  ///< W/m2, if the scene was compiled with it and all corners have it

  /// Where rays start that leave the triangle in this direction.
  Vec3f origin_towards(const Vec3f& direction) const {
    return offset_towards(position, error, geometric_normal, direction);
  }
};

/// The start of a ray.
struct RayStart {
  Vec3f origin;
  TriangleId from;  ///< which it cannot hit
};

}  // namespace transport
