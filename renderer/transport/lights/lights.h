#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "renderer/transport/lights/light_tree.h"

namespace transport {

/// A point on an emitter, as it is seen from where light is wanted.
struct LightSample {
  Vec3f direction;  ///< towards the light, unit
  Vec3f position;
  Vec3f error;   ///< bounds of the position's rounding error
  Vec3f normal;  ///< of the emitter's front, unit
  Rgb radiance;
  float density = 0;  ///< per solid angle, over 0, the choice of the emitter included
  std::uint32_t emitter = 0;
};

/// All that emits and has a place, to be sampled by solid angle: an emitter by the light tree, and then a
/// direction evenly over what is seen of it; or a point evenly over one that is more than two of its
/// diagonals away, where that is as good.
class Lights {
 public:
  Lights() = default;
  explicit Lights(std::vector<Emitter> emitters);

  bool empty() const { return emitters_.empty(); }
  std::size_t size() const { return emitters_.size(); }
  const Emitter& operator[](std::size_t index) const { return emitters_[index]; }

  /// Light for a surface at a point; `normal` is its unit shading normal, on the side that is looked at.
  /// `choice` picks the emitter, xi the point; all are in [0,1). Nothing if what was picked shows only its
  /// back or is under the horizon. There must be an emitter.
  std::optional<LightSample> sample(const Vec3f& from, const Vec3f& normal, float choice,
                                    const Vec2f& xi) const;

  /// The density of `sample` in a direction in which the emitter is seen, per solid angle; 0 where `sample`
  /// would not pick it.
  float density(const Vec3f& from, const Vec3f& normal, std::size_t emitter, const Vec3f& direction) const;

  /// The sum over emitters, in watts.
  double power() const { return power_; }

  std::size_t bytes() const { return emitters_.capacity() * sizeof(Emitter) + tree_.bytes(); }

 private:
  std::vector<Emitter> emitters_;
  LightTree tree_;
  double power_ = 0;
};

}  // namespace transport
