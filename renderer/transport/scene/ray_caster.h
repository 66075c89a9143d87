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

  /// The nearest triangle in front of the origin.
  std::optional<TriangleHit> intersect(const Ray& ray) const;

  /// Whether anything lies between the origin and origin + direction, except `count` triangles from `target`
  /// on: the triangles that the ray ends on do not occlude it.
  bool is_occluded(const Ray& ray, const TriangleId& target = {}, std::uint32_t count = 0) const;

  /// Whether nothing is in front of the origin, at any distance.
  bool is_unoccluded(const Ray& ray) const;

  /// Returns the triangles whose bounding boxes reach within this distance of a point, and perhaps some
  /// others, in any order.
  std::vector<TriangleId> triangles_near(const Vec3f& point, float distance) const;

 private:
  struct Scenes;
  std::shared_ptr<const Scenes> scenes_;
};

}  // namespace transport
