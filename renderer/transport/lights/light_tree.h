#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "renderer/transport/lights/light_bounds.h"

namespace transport {

/// A light tree (light BVH): a binary tree over emitters that samples one by importance (Conty Estevez and
/// Kulla 2018; Pharr, Jakob and Humphreys 2023, "Physically based rendering", section 12.6.3). The tree does
/// not depend on the number of threads that build it.
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
  /// and `choice` is in [0,1). Empty if no emitter can contribute. May also be empty because a cluster's
  /// bound was loose, so probabilities can sum to less than 1.
  std::optional<Choice> choose(std::span<const Emitter> emitters, const Vec3f& from, const Vec3f& normal,
                               double choice) const;

  /// The probability that `choose` returns this emitter.
  float probability(std::span<const Emitter> emitters, const Vec3f& from, const Vec3f& normal,
                    std::uint32_t emitter) const;

  std::size_t bytes() const {
    return nodes_.capacity() * sizeof(Node) + parent_of_emitter_.capacity() * sizeof(std::uint32_t);
  }

 private:
  friend class LightTreeBuilder;

  /// Marks a child as an emitter; otherwise it is a node.
  static constexpr std::uint32_t IsEmitter = 0x80000000U;

  struct Node {
    LightBounds bounds;
    std::uint32_t children[2] = {0, 0};
    std::uint32_t parent = 0;
  };

  float importance_of(std::uint32_t child, std::span<const Emitter> emitters, const Vec3f& from,
                      const Vec3f& normal) const {
    return (child & IsEmitter) != 0 ? importance(emitters[child & ~IsEmitter], from, normal)
                                    : importance(nodes_[child].bounds, from, normal);
  }

  std::vector<Node> nodes_;  ///< the root first; one fewer than emitters
  std::vector<std::uint32_t> parent_of_emitter_;
};

}  // namespace transport
