#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "renderer/transport/lights/light_bounds.h"

namespace transport {

/// A binary tree over emitters, to choose one in proportion to a guess of what it gives to a point (Conty
/// Estevez and Kulla 2018; Pharr, Jakob and Humphreys 2023, "Physically based rendering", section 12.6.3).
/// It is the same whatever the number of threads that build it.
class LightTree {
 public:
  struct Choice {
    std::uint32_t emitter = 0;
    float probability = 1;
  };

  LightTree() = default;
  /// Those without power are never chosen.
  explicit LightTree(std::span<const Emitter> emitters);

  /// The emitters must be those that the tree was made of, and `normal` the receiver's. Nothing if none seems
  /// to reach the point; that one does may turn out only when some were ruled out, so probabilities may add
  /// up to less than 1. `choice` is in [0,1).
  std::optional<Choice> choose(std::span<const Emitter> emitters, const Vec3f& from, const Vec3f& normal,
                               double choice) const;

  /// That `choose` gives this emitter.
  float probability(std::span<const Emitter> emitters, const Vec3f& from, const Vec3f& normal,
                    std::uint32_t emitter) const;

  std::size_t bytes() const {
    return nodes_.capacity() * sizeof(Node) + parent_of_emitter_.capacity() * sizeof(std::uint32_t);
  }

 private:
  friend class LightTreeBuilder;

  /// A child is another node, or an emitter if it has this bit.
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

  std::vector<Node> nodes_;  ///< the root first; one less than emitters
  std::vector<std::uint32_t> parent_of_emitter_;
};

}  // namespace transport
