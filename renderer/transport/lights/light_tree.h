#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "renderer/transport/lights/light_bounds.h"

namespace transport {

/// A light tree (light BVH) over emitters that samples one by importance (Conty Estevez and Kulla 2018;
/// Pharr, Jakob and Humphreys 2023, "Physically based rendering", section 12.6.3). Its nodes have up to eight
/// children, whose importance is computed in vector registers: that takes a third of the levels of a binary
/// tree, and is more accurate, as large clusters are compared less often. The tree does not depend on the
/// number of threads that build it.
class LightTree {
 public:
  struct Choice {
    std::uint32_t emitter = 0;
    float probability = 1;
  };

  LightTree() = default;
  /// Emitters without power are never sampled.
  explicit LightTree(std::span<const Emitter> emitters);

  /// Samples an emitter. The emitters must be those that the tree was built from, `normal` is the receiver's,
  /// and `choice` is in [0,1). Empty if no emitter can contribute. May also be empty because a bound was
  /// loose, so probabilities can sum to less than 1.
  std::optional<Choice> choose(std::span<const Emitter> emitters, const Vec3f& from, const Vec3f& normal,
                               double choice) const;

  /// The probability that `choose` returns this emitter.
  float probability(std::span<const Emitter> emitters, const Vec3f& from, const Vec3f& normal,
                    std::uint32_t emitter) const;

  std::size_t bytes() const {
    return nodes_.capacity() * sizeof(Node) + place_of_emitter_.capacity() * sizeof(Place);
  }

 private:
  friend class LightTreeBuilder;

  static constexpr int Width = LightBounds8::Size;
  /// Marks a child as an emitter; otherwise it is a node.
  static constexpr std::uint32_t IsEmitter = 0x80000000U;

  /// A child of a node.
  struct Place {
    std::uint32_t node = 0;
    std::uint32_t child = 0;  ///< less than Width
  };

  struct Node {
    LightBounds8 bounds;
    std::array<std::uint32_t, Width> children{};
    Place parent;
  };

  std::vector<Node> nodes_;  ///< the root first; none for one emitter
  std::vector<Place> place_of_emitter_;
};

}  // namespace transport
