// How one casts rays first: what rows of the catalogue compare with.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "renderer/transport/scene/geometry.h"
#include "tests/stability/hard_case.h"

namespace test {

/// Every triangle in turn, each by itself, in float (Moeller and Trumbore 1997, "Fast, minimum storage
/// ray/triangle intersection").
class NaiveTracer {
 public:
  using Corners = std::array<transport::Vec3f, 3>;
  struct Hit {
    std::size_t triangle = 0;
    float distance = 0;       ///< in lengths of the direction
    transport::Vec3f normal;  ///< unit, as the corners turn
  };

  /// Hits nearer than `nearest`, and determinants below `least_determinant`, do not count.
  explicit NaiveTracer(std::vector<Corners> triangles, float nearest = 0, float least_determinant = 0)
      : triangles_(std::move(triangles)), nearest_(nearest), least_determinant_(least_determinant) {}

  std::optional<Hit> intersect(const transport::Vec3f& origin, const transport::Vec3f& direction) const;

 private:
  std::vector<Corners> triangles_;
  float nearest_;
  float least_determinant_;
};

/// The triangles of what is no instance, moved by an offset in float.
std::vector<NaiveTracer::Corners> triangles_of(const transport::Geometry& geometry,
                                               const transport::Vec3f& offset = transport::Vec3f(0));

}  // namespace test
