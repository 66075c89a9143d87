#pragma once

#include <cstdint>
#include <vector>

#include "grf/math.h"
#include "renderer/reflectance/geometry.h"

namespace transport {

using grf::Colour;
using grf::Vec2f;
using grf::Vec3f;
using reflectance::Rgb;

/// A parallelogram, or the half of one that is a triangle, that emits from its front: the side to which
/// edge1 x edge2 points.
struct Emitter {
  Vec3f corner;
  Vec3f edge1;
  Vec3f edge2;
  bool is_triangle = false;
  Rgb radiance;  ///< W/(sr m2)

  Vec3f doubled_area_normal() const { return edge1.cross(edge2); }
  float area() const { return doubled_area_normal().length() / (is_triangle ? 2 : 1); }
};

/// A point on an emitter, as it is seen from where light is wanted.
struct LightSample {
  Vec3f position;
  Vec3f error;  ///< bounds of the position's rounding error
  Vec3f normal;
  Rgb radiance;
  float density = 0;  ///< per unit of emitting area, the choice of the emitter included
  std::uint32_t emitter = 0;
};

/// All that emits, to be sampled in proportion to power.
class Emitters {
 public:
  Emitters() = default;
  explicit Emitters(std::vector<Emitter> emitters);

  bool empty() const { return emitters_.empty(); }
  const Emitter& operator[](std::size_t index) const { return emitters_[index]; }
  std::size_t size() const { return emitters_.size(); }

  /// `choice` picks the emitter, xi the point; there must be an emitter.
  LightSample sample(float choice, const Vec2f& xi) const;

  /// The density of `sample` per unit of area, anywhere on that emitter.
  float area_density(std::size_t index) const { return probability_[index] / area_[index]; }

 private:
  std::vector<Emitter> emitters_;
  std::vector<float> area_;
  std::vector<float> probability_;
  std::vector<float> cumulative_;  ///< of the probabilities, up to and including each
};

}  // namespace transport
