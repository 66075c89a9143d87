// A compiled scene has immutable triangles and tables for ray tracing, made in one explicit step from the
// scene that people edit. No step renumbers faces.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "grf/diagnostics.h"
#include "grf/scene.h"
#include "renderer/transport/effect.h"
#include "renderer/transport/lights/lights.h"
#include "renderer/transport/scene/geometry.h"
#include "renderer/transport/scene/ray_caster.h"
#include "renderer/transport/scene/reflector_set.h"
#include "renderer/transport/scene/surface_point.h"
#include "renderer/transport/scene/surface_set.h"
#include "renderer/transport/scene/texture_set.h"

namespace transport {

class HitTriangle;

/// Coordinates of rays and hits are those of the world minus an origin, which is (0,0,0) except in scenes so
/// far from the world's origin that float precision would not suffice.
class CompiledScene {
 public:
  /// `caster` must serve the geometry.
  CompiledScene(std::shared_ptr<const Geometry> geometry, RayCaster caster,
                std::vector<CompiledSurface> surfaces, std::vector<VaryingSurface> varying,
                ReflectorSet reflectors, std::vector<TextureFile> textures, std::vector<Emitter> emitters);

  /// Returns the nearest point that stops the ray. A face of opacity a does so with probability a: equal
  /// values of `chance`, a random word, give equal points, and different ones independent decisions.
  std::optional<SurfacePoint> intersect(const Ray& ray, std::uint32_t chance = 0) const;

  /// Returns where a ray starts that leaves a surface in a direction on the side of this normal. For a
  /// direction below that side, only if `terminator_offset` leads above the triangle there and the offset is
  /// unoccluded: light does not leak through walls. Adds the rays that this takes to `rays`.
  std::optional<RayStart> start_of(const SurfacePoint& point, const Vec3f& direction,
                                   const Vec3f& geometric_side, std::uint64_t& rays) const {
    if (direction.dot(geometric_side) > 0) return RayStart{point.origin_towards(direction), point.id};
    return offset_start(point, geometric_side, rays);
  }
  /// Returns a point of a triangle as if a ray had hit it from the front, given the barycentric weights of
  /// the second and third corner; without colour, texture and tangent.
  SurfacePoint front_point(const TriangleId& id, const Vec2f& weights) const;

  /// The fraction of light that passes straight on between the origin and origin + direction; if the end is a
  /// point of an emitter, the emitter itself does not count. Solids of glass let none pass, as they bend it.
  Rgb transmittance_to_end(const Ray& ray, std::uint32_t emitter = InvalidIndex) const;
  /// The fraction of light that passes in front of the origin, at any distance.
  Rgb transmittance(const Ray& ray) const;
  /// Whether no light passes, see `transmittance_to_end`.
  bool is_occluded(const Ray& ray, std::uint32_t emitter = InvalidIndex) const {
    return reflectance::is_black(transmittance_to_end(ray, emitter));
  }
  bool is_unoccluded(const Ray& ray) const { return !reflectance::is_black(transmittance(ray)); }

  /// The opacity of an emitter at a sampled point, as far as it varies: a constant one is part of its
  /// radiance.
  float opacity_at(const LightSample& light) const { return has_cutouts_ ? opacity_of_emitter(light) : 1; }

  bool has_cutouts() const { return has_cutouts_; }  ///< some face lets light pass straight on
  bool has_glass() const { return has_glass_; }      ///< some face is glass, a pane or that of a solid
  bool has_varying_brdfs() const { return !varying_.empty(); }  ///< images vary the BRDF of some face

  /// Moves a point off the faces that it lies in, by the rounding error of rays that start there: to the side
  /// that the direction points to if the point is in a face within the rounding of the face's corners, and
  /// else to the point's own side. Without this, such rays would hit the face or not by chance.
  grf::Vec3d off_faces(const grf::Vec3d& point, const grf::Vec3d& direction) const;

  const Lights& lights() const { return lights_; }
  /// The reflector of a surface, null if it is black. Where images vary it, that of the factors.
  const reflectance::Reflector* reflector(const CompiledSurface& surface) const {
    return surface.reflector == InvalidIndex ? nullptr : &reflectors_.reflectors[surface.reflector];
  }
  /// The reflector at a point that a ray has hit, likewise. `varied` holds it where images vary it.
  const reflectance::Reflector* reflector_at(const SurfacePoint& point,
                                             std::optional<reflectance::Reflector>& varied) const {
    const reflectance::Reflector* constant = reflector(*point.surface);
    return point.surface->varying == InvalidIndex ? constant : &vary(*constant, point, varied);
  }

  const Geometry& geometry() const { return *geometry_; }
  /// The origin, to be subtracted from world coordinates.
  const grf::Vec3d& origin() const { return geometry_->origin; }
  Vec3f to_local(const grf::Vec3d& world) const { return Vec3f(world - geometry_->origin); }
  const grf::Box3d& bounds() const { return geometry_->bounds; }  ///< in world space

  std::size_t triangle_count() const;                                             ///< each instance counted
  std::size_t instance_count() const { return geometry_->instances.size() - 1; }  ///< of shared meshes
  std::size_t bytes() const;  ///< of triangles, their attributes and textures, without Embree's data
  std::size_t texture_count() const { return textures_.size(); }
  /// Whether all that reflects is `diffuse`, with cosine-weighted sampling.
  bool is_diffuse() const;

  /// The tables of the sampling schemes, for each pair of BRDF and scheme.
  const std::vector<TableInfo>& tables() const { return reflectors_.tables; }
  /// The time that building them took, s.
  double table_seconds() const { return reflectors_.seconds; }

  // Parts that another scene can share.
  const RayCaster& caster() const { return caster_; }
  const ReflectorSet& reflectors() const { return reflectors_; }
  const std::vector<TextureFile>& textures() const { return textures_; }

 private:
  class NearestStop;
  class Passage;
  const CompiledSurface& surface_at(const TriangleHit& hit) const;
  float opacity_at(const TriangleHit& hit, const Ray& ray) const;
  Rgb colour_at(const HitTriangle& hit, const CompiledSurface& surface, float width) const;
  const reflectance::Reflector& vary(const reflectance::Reflector& constant, const SurfacePoint& point,
                                     std::optional<reflectance::Reflector>& varied) const;
  Rgb passing_pane(const TriangleHit& hit, const Ray& ray, const CompiledSurface& surface) const;
  float opacity_of_emitter(const LightSample& light) const;
  std::optional<RayStart> offset_start(const SurfacePoint& point, const Vec3f& geometric_side,
                                       std::uint64_t& rays) const;

  std::shared_ptr<const Geometry> geometry_;
  std::vector<CompiledSurface> surfaces_;
  std::vector<VaryingSurface> varying_;
  ReflectorSet reflectors_;
  std::vector<TextureFile> textures_;
  Lights lights_;
  RayCaster caster_;
  bool has_cutouts_ = false;
  bool has_glass_ = false;
};

struct CompileSettings {
  std::optional<SchemeOverride> scheme;  ///< also checked against the catalogue
  reflectance::MissedPart missed_part = reflectance::MissedPart::DrawnByCosine;
  reflectance::Precision precision = reflectance::Precision::Float;
  int threads = 0;                                       ///< threads to compile with; 0: one per core
  bool has_irradiance = false;                           ///< keeps the irradiance of vertices
  EffectSet effects = EffectSet::all();                  ///< effects that the scene needs
  std::shared_ptr<const ReflectingSurfaces> reflecting;  ///< the others are black; null: all
  /// A mesh that is placed more than once is copied, if all copies together have at most this many triangles:
  /// they are faster to intersect than instances.
  std::size_t most_copied_triangles = 10'000;
  image::ImageReader image_reader =
      image::read_image;  ///< reads textures, possibly in several threads at once
  /// Requests to stop, which are checked between steps; each table of a sampling scheme is one.
  std::stop_token stop;
};

/// The limit from `settings`, or no limit if instancing is off.
std::size_t most_copied_triangles(const CompileSettings& settings);

/// Compiles a scene that was checked against the catalogue. A sampling scheme that cannot serve the BRDF of
/// its faces, and an image that cannot be read, are errors; the result is then empty, as it is after a
/// request to stop.
///
/// Shares with the scene `before`, if there is one, what has not changed since: the acceleration
/// structure if no triangle has moved, tables of sampling schemes, and textures whose files have not changed.
std::optional<CompiledScene> compile(const grf::Scene& scene, grf::Diagnostics& diagnostics,
                                     const CompileSettings& settings = {},
                                     const CompiledScene* before = nullptr);

/// The same, and frees what only the scene holds before memory for the acceleration structure is needed.
std::optional<CompiledScene> compile(grf::Scene&& scene, grf::Diagnostics& diagnostics,
                                     const CompileSettings& settings = {},
                                     const CompiledScene* before = nullptr);

}  // namespace transport
