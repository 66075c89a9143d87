#include "renderer/transport/lights/light_tree.h"

#include <algorithm>

#include "renderer/transport/lights/light_tree_builder.h"

namespace transport {

LightTree::LightTree(std::span<const Emitter> emitters) {
  if (emitters.size() > 1) LightTreeBuilder(emitters, *this).build();
}

std::optional<LightTree::Choice> LightTree::choose(std::span<const Emitter> emitters, const Vec3f& from,
                                                   const Vec3f& normal, double choice) const {
  if (nodes_.empty()) return Choice{};
  double probability = 1;
  std::uint32_t at = 0;
  while ((at & IsEmitter) == 0) {
    const Node& node = nodes_[at];
    const double first = importance_of(node.children[0], emitters, from, normal);
    const double both = first + importance_of(node.children[1], emitters, from, normal);
    if (!(both > 0)) return std::nullopt;
    const double share = first / both;
    const bool is_second = choice >= share;
    const double taken = is_second ? 1 - share : share;
    if (!(taken > 0)) return std::nullopt;
    choice = std::clamp((is_second ? choice - share : choice) / taken, 0.0, 1 - 0x1p-53);
    probability *= taken;
    at = node.children[is_second ? 1 : 0];
  }
  return Choice{at & ~IsEmitter, static_cast<float>(probability)};
}

float LightTree::probability(std::span<const Emitter> emitters, const Vec3f& from, const Vec3f& normal,
                             std::uint32_t emitter) const {
  if (nodes_.empty()) return 1;
  double probability = 1;
  std::uint32_t child = emitter | IsEmitter;
  std::uint32_t parent = parent_of_emitter_[emitter];
  for (;;) {
    const Node& node = nodes_[parent];
    const double first = importance_of(node.children[0], emitters, from, normal);
    const double both = first + importance_of(node.children[1], emitters, from, normal);
    const double share = first / both;
    probability *= child == node.children[0] ? share : 1 - share;
    if (!(probability > 0)) return 0;
    if (parent == 0) return static_cast<float>(probability);
    child = parent;
    parent = node.parent;
  }
}

}  // namespace transport
