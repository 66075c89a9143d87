#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "renderer/transport/scene/geometry.h"
#include "renderer/transport/scene/ray.h"

namespace transport {

struct TriangleHit {
  TriangleId id;
  /// Weights of the second and the third corner.
  float u = 0, v = 0;
  float distance = 0;  ///< in lengths of the ray's direction
};

/// Finds what rays meet: the one user of Embree. Its robust mode leaves no cracks along shared edges of a
/// mesh. A ray that aims at a vertex itself, and passes it within some roundings of their distance, can get
/// through there, if the triangles at the vertex are small for that distance.
///
/// The first mesh is met without a transform; the others through Embree's instances, and only those that an
/// instance places.
///
/// Copies share what was built.
class RayCaster {
 public:
  /// Keeps the geometry. The last position of a mesh is not to be used: Embree reads 16 bytes for a vertex of
  /// 12, so one is needed behind the others.
  explicit RayCaster(std::shared_ptr<const Geometry> geometry);

  /// True if this meets what one of that geometry would.
  bool serves(const Geometry& geometry) const;
  bool shares(const RayCaster& other) const { return scenes_ == other.scenes_; }

  /// The nearest triangle in front of the origin.
  std::optional<TriangleHit> intersect(const Ray& ray) const;

  /// True if anything is between the origin and origin + direction, but for `count` triangles from `target`
  /// on: what the ray ends on is not in its own way.
  bool is_occluded(const Ray& ray, const TriangleId& target = {}, std::uint32_t count = 0) const;

  /// True if nothing is in front of the origin, however far.
  bool escapes(const Ray& ray) const;

 private:
  struct Scenes;
  std::shared_ptr<const Scenes> scenes_;
};

}  // namespace transport
