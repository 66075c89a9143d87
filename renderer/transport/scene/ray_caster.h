#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "grf/math.h"

namespace transport {

using grf::Vec3f;

struct Ray {
  Vec3f origin;
  Vec3f direction;  ///< need not be of unit length: distances along the ray count in its lengths
};

struct TriangleHit {
  std::uint32_t triangle = 0;
  /// Weights of the second and the third corner.
  float u = 0, v = 0;
};

/// Finds what rays meet: the one user of Embree. Its robust mode leaves no cracks along shared edges.
class RayCaster {
 public:
  /// Triangles as three vertex indices each. The arrays must outlive the caster, and the last position is
  /// not to be used: Embree reads 16 bytes for a vertex of 12, so one is needed behind the others.
  RayCaster(std::span<const Vec3f> positions, std::span<const std::uint32_t> triangles);
  ~RayCaster();
  RayCaster(RayCaster&&) noexcept;
  RayCaster& operator=(RayCaster&&) noexcept;

  /// The nearest triangle in front of the origin.
  std::optional<TriangleHit> intersect(const Ray& ray) const;

  /// True if anything is between the origin and origin + direction, but for the last 1e-4 of the way: what
  /// the ray ends on is not in its own way.
  bool is_occluded(const Ray& ray) const;

  /// True if nothing is in front of the origin, however far.
  bool escapes(const Ray& ray) const;

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

}  // namespace transport
