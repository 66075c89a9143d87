// A scene for rays: immutable, triangles and tables. Made in one explicit step from the scene that people
// edit; no station on the way renumbers faces.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "grf/diagnostics.h"
#include "grf/scene.h"
#include "renderer/transport/lights/lights.h"
#include "renderer/transport/plan/effect.h"
#include "renderer/transport/scene/geometry.h"
#include "renderer/transport/scene/ray_caster.h"
#include "renderer/transport/scene/reflector_set.h"
#include "renderer/transport/scene/surface_point.h"
#include "renderer/transport/scene/surface_set.h"
#include "renderer/transport/scene/texture_set.h"

namespace transport {

/// Coordinates, of rays and of what they meet, are those of the world less an origin. That is (0,0,0) but for
/// scenes so far from the world's origin that floats would make steps of them.
class CompiledScene {
 public:
  /// The caster is one that serves the geometry.
  CompiledScene(std::shared_ptr<const Geometry> geometry, RayCaster caster,
                std::vector<CompiledSurface> surfaces, ReflectorSet reflectors,
                std::vector<TextureFile> textures, std::vector<Emitter> emitters);

  std::optional<SurfacePoint> intersect(const Ray& ray) const;

  /// Where a ray starts that leaves a surface in a direction above it, on the side of this normal. Under it
  /// only if `rise` leads up to that side, and nothing is on that way: light does not get through a wall.
  /// Adds the rays that this takes to `rays`.
  std::optional<RayStart> start_of(const SurfacePoint& point, const Vec3f& direction,
                                   const Vec3f& geometric_side, std::uint64_t& rays) const {
    if (direction.dot(geometric_side) > 0) return RayStart{point.origin_towards(direction), point.id};
    return raised_start(point, geometric_side, rays);
  }
  /// A point of a triangle as a ray would meet it from the front, with the weights of the second and the
  /// third corner; without colour, texture and tangent.
  SurfacePoint front_point(const TriangleId& id, const Vec2f& weights) const;

  /// True if anything is between the origin and origin + direction; if that is a point of an emitter, then
  /// but for the emitter itself.
  bool is_occluded(const Ray& ray, std::uint32_t emitter = None) const;
  bool escapes(const Ray& ray) const { return caster_.escapes(ray); }

  const Lights& lights() const { return lights_; }
  const reflectance::Reflector* reflector(const CompiledSurface& surface) const {
    return surface.reflector == None ? nullptr : &reflectors_.reflectors[surface.reflector];
  }

  const Geometry& geometry() const { return *geometry_; }
  /// What to subtract from coordinates of the world.
  const grf::Vec3d& origin() const { return geometry_->origin; }
  Vec3f to_local(const grf::Vec3d& world) const { return Vec3f(world - geometry_->origin); }
  const grf::Box3d& bounds() const { return geometry_->bounds; }  ///< in the world

  std::size_t triangle_count() const;                                             ///< each instance counted
  std::size_t instance_count() const { return geometry_->instances.size() - 1; }  ///< of shared meshes
  std::size_t bytes() const;  ///< of triangles, their attributes and textures, without what Embree has
  std::size_t texture_count() const { return textures_.size(); }
  /// True if all that reflects is `diffuse`, sampled by cosine.
  bool is_matte() const;

  /// What the tables of the sampling schemes hold, for each pair of BRDF and scheme.
  const std::vector<TableInfo>& tables() const { return reflectors_.tables; }
  /// How long building them took.
  double table_seconds() const { return reflectors_.seconds; }

  // What another scene can share.
  const RayCaster& caster() const { return caster_; }
  const ReflectorSet& reflectors() const { return reflectors_; }
  const std::vector<TextureFile>& textures() const { return textures_; }

 private:
  std::optional<RayStart> raised_start(const SurfacePoint& point, const Vec3f& geometric_side,
                                       std::uint64_t& rays) const;

  std::shared_ptr<const Geometry> geometry_;
  std::vector<CompiledSurface> surfaces_;
  ReflectorSet reflectors_;
  std::vector<TextureFile> textures_;
  Lights lights_;
  RayCaster caster_;
};

struct CompileSettings {
  std::optional<SchemeOverride> scheme;  ///< checked against the catalogue too
  reflectance::MissedPart missed_part = reflectance::MissedPart::DrawnByCosine;
  reflectance::Precision precision = reflectance::Precision::Float;
  int threads = 0;                       ///< threads to compile with; 0: as many as the machine has
  bool has_irradiance = false;           ///< keeps the irradiance of vertices
  EffectSet effects = EffectSet::all();  ///< what of others is to be in the scene
  std::shared_ptr<const ReflectingSurfaces> reflecting;  ///< the others are black; null: all
  /// A mesh that is placed more than once is copied if all its copies together have no more triangles than
  /// that: rays meet them sooner than instances.
  std::size_t most_copied_triangles = 10'000;
  ImageReader image_reader = read_image;  ///< reads textures, perhaps in several threads at once
  /// Asks for an end at the next of the steps; a table of a sampling scheme is one.
  std::stop_token stop;
};

/// That of the settings, unless there are to be no instances at all.
std::size_t most_copied_triangles(const CompileSettings& settings);

/// Compiles a scene that was checked against the catalogue. A sampling scheme that cannot serve the BRDF of
/// its faces, and an image that cannot be read, is an error, and nothing is returned; nor after it was asked
/// to stop.
///
/// What is the same in the scene `before`, if there is one, is shared with it: what casts rays, where no
/// triangle has moved; tables of sampling schemes; and textures whose files have not changed.
std::optional<CompiledScene> compile(const grf::Scene& scene, grf::Diagnostics& diagnostics,
                                     const CompileSettings& settings = {},
                                     const CompiledScene* before = nullptr);

/// The same, and frees what the scene alone holds before the memory for casting rays is needed.
std::optional<CompiledScene> compile(grf::Scene&& scene, grf::Diagnostics& diagnostics,
                                     const CompileSettings& settings = {},
                                     const CompiledScene* before = nullptr);

}  // namespace transport
