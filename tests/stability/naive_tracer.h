// A naive ray tracer, with which rows of the catalogue compare.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "renderer/transport/scene/geometry.h"
#include "tests/stability/hard_case.h"

namespace test {

/// Intersects every triangle separately in float (Moeller and Trumbore 1997, "Fast, minimum storage
/// ray/triangle intersection").
class NaiveTracer {
 public:
  using Corners = std::array<transport::Vec3f, 3>;
  struct Hit {
    std::size_t triangle = 0;
    float distance = 0;       ///< in units of the direction's length
    transport::Vec3f normal;  ///< unit, oriented by the corners
  };

  /// Ignores hits nearer than `nearest`, and determinants below `least_determinant`.
  explicit NaiveTracer(std::vector<Corners> triangles, float nearest = 0, float least_determinant = 0)
      : triangles_(std::move(triangles)), nearest_(nearest), least_determinant_(least_determinant) {}

  std::optional<Hit> intersect(const transport::Vec3f& origin, const transport::Vec3f& direction) const;

 private:
  std::vector<Corners> triangles_;
  float nearest_;
  float least_determinant_;
};

/// Returns the triangles of geometry without instances, translated in float.
std::vector<NaiveTracer::Corners> triangles_of(const transport::Geometry& geometry,
                                               const transport::Vec3f& offset = transport::Vec3f(0));

}  // namespace test
