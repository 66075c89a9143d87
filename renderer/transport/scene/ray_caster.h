#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "renderer/transport/scene/geometry.h"
#include "renderer/transport/scene/ray.h"

namespace transport {

struct TriangleHit {
  TriangleId id;
  /// Barycentric weights of the second and third corner.
  float u = 0, v = 0;
  float distance = 0;  ///< in lengths of the ray's direction
};

/// Decides which hits stop a ray, where triangles can let light pass.
class HitFilter {
 public:
  virtual ~HitFilter() = default;

  /// Called for hits in any order, also for those behind the nearest one that stops the ray. Only triangles
  /// of meshes with cut-outs are asked for.
  virtual bool stops(const TriangleHit& hit) = 0;

 protected:
  HitFilter() = default;
  HitFilter(const HitFilter&) = default;
  HitFilter& operator=(const HitFilter&) = default;
};

/// Intersects rays with the geometry, through Embree, which no other file uses. Its robust mode leaves no
/// cracks along shared edges of a mesh. A ray aimed at a vertex, which passes it within a few rounding errors
/// of the distance, can slip through if the triangles at the vertex are small for that distance.
///
/// The first mesh is intersected without a transform, the others through Embree's instances; meshes that no
/// instance places are left out.
///
/// Copies share the acceleration structure.
class RayCaster {
 public:
  /// Keeps the geometry. The last position of a mesh is padding, because Embree reads 16 bytes per vertex of
  /// 12.
  explicit RayCaster(std::shared_ptr<const Geometry> geometry);

  /// Whether this intersects rays as a caster of that geometry would.
  bool serves(const Geometry& geometry) const;
  bool shares(const RayCaster& other) const { return scenes_ == other.scenes_; }

  /// The nearest triangle in front of the origin that stops the ray; without a filter, all do.
  std::optional<TriangleHit> intersect(const Ray& ray, HitFilter* filter = nullptr) const;

  /// Whether anything lies between the origin and origin + direction, except `count` triangles from `target`
  /// on: the triangles that the ray ends on do not occlude it. With a filter, only what stops the ray counts.
  bool is_occluded(const Ray& ray, const TriangleId& target = {}, std::uint32_t count = 0,
                   HitFilter* filter = nullptr) const;

  /// Whether nothing is in front of the origin, at any distance.
  bool is_unoccluded(const Ray& ray, HitFilter* filter = nullptr) const;

  /// Returns the triangles whose bounding boxes reach within this distance of a point, and perhaps some
  /// others, in any order.
  std::vector<TriangleId> triangles_near(const Vec3f& point, float distance) const;

 private:
  struct Scenes;
  std::shared_ptr<const Scenes> scenes_;
};

}  // namespace transport
