// A scene for rays: flat, immutable, triangles and tables. Made in one explicit step from the scene that
// people edit; no station on the way renumbers faces.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "grf/diagnostics.h"
#include "grf/scene.h"
#include "renderer/transport/lights/lights.h"
#include "renderer/transport/scene/ray_caster.h"
#include "renderer/transport/scene/ray_offset.h"
#include "renderer/transport/scene/reflector_set.h"

namespace transport {

constexpr std::uint32_t None = std::numeric_limits<std::uint32_t>::max();

struct CompiledSurface {
  Rgb colour = Rgb(1);
  Rgb emission = Rgb(0);
  std::uint32_t reflector = None;  ///< None: black
};

/// What a triangle has besides its corners.
struct TriangleSurface {
  std::uint32_t surface = 0;
  bool is_flat = true;  ///< shaded with its own normal and not with its corners'
};

/// Arrays of a scene in world space; the way from `grf::Scene` to `CompiledScene`.
struct Geometry {
  std::vector<Vec3f> positions;
  std::vector<Vec3f> normals;   ///< unit, or 0 where a vertex has none; empty if no vertex has one
  std::vector<Colour> colours;  ///< 1 where a vertex has none; empty if no vertex has one
  std::vector<std::uint32_t> triangles;
  std::vector<TriangleSurface> triangle_surfaces;
  std::vector<std::uint32_t> emitter_of_triangle;  ///< None for most; empty if nothing emits
  grf::Box3f bounds;
};

/// What a scene makes a path tracer do. A kernel is to do no more than that.
struct Effects {
  bool area_lights = false;
  bool diffuse_reflection = false;
  bool glossy_reflection = false;
  bool mirror_reflection = false;
  bool anisotropy = false;
  bool interpolated_normals = false;
  bool vertex_colours = false;

  std::vector<std::string> names() const;
};

/// Where a ray met a surface.
struct SurfacePoint {
  Vec3f position;
  Vec3f error;             ///< bounds of the position's rounding error, for each axis
  Vec3f geometric_normal;  ///< unit, on the front
  Vec3f shading_normal;    ///< unit
  Rgb colour;
  const CompiledSurface* surface = nullptr;
  std::uint32_t emitter = None;

  /// Where rays in this direction start.
  Vec3f origin_towards(const Vec3f& direction) const {
    return offset_towards(position, error, geometric_normal, direction);
  }
};

class CompiledScene {
 public:
  CompiledScene(Geometry geometry, std::vector<CompiledSurface> surfaces, ReflectorSet reflectors,
                Lights lights);

  std::optional<SurfacePoint> intersect(const Ray& ray) const;
  bool is_occluded(const Ray& ray) const { return caster_.is_occluded(ray); }
  bool escapes(const Ray& ray) const { return caster_.escapes(ray); }

  const Lights& lights() const { return lights_; }
  const reflectance::Reflector* reflector(const CompiledSurface& surface) const {
    return surface.reflector == None ? nullptr : &reflectors_.reflectors[surface.reflector];
  }
  const grf::Box3f& bounds() const { return geometry_.bounds; }
  std::size_t triangle_count() const { return geometry_.triangle_surfaces.size(); }
  Effects effects() const;
  /// True if all that reflects is `diffuse`, sampled by cosine.
  bool is_matte() const;

  /// What the tables of the sampling schemes hold, for each pair of BRDF and scheme.
  const std::vector<TableInfo>& tables() const { return reflectors_.tables; }
  /// How long building them took.
  double table_seconds() const { return reflectors_.seconds; }

 private:
  SurfacePoint point_at(const TriangleHit& hit) const;

  Geometry geometry_;
  std::vector<CompiledSurface> surfaces_;
  ReflectorSet reflectors_;
  Lights lights_;
  RayCaster caster_;  ///< shares the triangles of the geometry
};

struct CompileSettings {
  std::optional<SchemeOverride> scheme;  ///< checked against the catalogue too
  reflectance::MissedPart missed_part = reflectance::MissedPart::DrawnByCosine;
  int threads = 0;  ///< that make tables; 0: as many as the machine has
};

/// Compiles a scene that was checked against the catalogue. A sampling scheme that cannot serve the BRDF of
/// its faces is an error, and nothing is returned.
std::optional<CompiledScene> compile(const grf::Scene& scene, grf::Diagnostics& diagnostics,
                                     const CompileSettings& settings = {});

}  // namespace transport
