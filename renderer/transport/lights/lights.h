#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "renderer/transport/lights/light_tree.h"

namespace transport {

/// A sampled point on an emitter, relative to a receiver.
struct LightSample {
  Vec3f direction;  ///< towards the light, unit
  Vec3f position;
  Vec3f error;   ///< bounds of the position's rounding error
  Vec3f normal;  ///< of the emitter's front, unit
  Rgb radiance;
  float pdf = 0;  ///< solid-angle pdf, 1/sr, over 0, which includes the choice of the emitter
  std::uint32_t emitter = 0;
  Vec2f place = Vec2f(0);  ///< from the emitter's corner, in multiples of its two edges
};

/// The scene's area lights, sampled by solid angle: an emitter by the light tree, then a direction uniformly
/// over its visible solid angle; or a point uniformly over its area if it is more than two of its diagonals
/// away, where that is as good.
class Lights {
 public:
  Lights() = default;
  explicit Lights(std::vector<Emitter> emitters);

  bool empty() const { return emitters_.empty(); }
  std::size_t size() const { return emitters_.size(); }
  const Emitter& operator[](std::size_t index) const { return emitters_[index]; }

  /// Samples light for a surface at a point; `normal` is its unit shading normal, on the viewer's side.
  /// `choice` selects the emitter, `xi` the point; all are in [0,1). Empty if the selected emitter faces away
  /// or is below the horizon. There must be an emitter.
  std::optional<LightSample> sample(const Vec3f& from, const Vec3f& normal, float choice,
                                    const Vec2f& xi) const;

  /// The solid-angle pdf of `sample` for a direction in which the emitter is visible; 0 where `sample` would
  /// not select it.
  float pdf(const Vec3f& from, const Vec3f& normal, std::size_t emitter, const Vec3f& direction) const;

  /// The total power of the emitters, W.
  double power() const { return power_; }

  std::size_t bytes() const { return emitters_.capacity() * sizeof(Emitter) + tree_.bytes(); }

 private:
  std::vector<Emitter> emitters_;
  LightTree tree_;
  double power_ = 0;
};

}  // namespace transport
