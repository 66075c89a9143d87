#include "renderer/transport/lights/light_tree.h"

#include <algorithm>

#include "renderer/transport/lights/light_tree_builder.h"

namespace transport {
namespace {

/// The importance of a node's children.
struct Importance {
  alignas(32) std::array<float, LightBounds8::Size> values;
  double total = 0;
  int last = 0;  ///< the last child whose importance is not 0

  Importance(const LightBounds8& bounds, const Vec3f& from, const Vec3f& normal) {
    bounds.importance(from, normal).copy_to(values.data(), std::experimental::vector_aligned);
    for (int i = 0; i < LightBounds8::Size; ++i) {
      total += double(values[i]);
      if (values[i] > 0) last = i;
    }
  }
};

}  // namespace

LightTree::LightTree(std::span<const Emitter> emitters) {
  if (emitters.size() > 1) LightTreeBuilder(emitters, *this).build();
}

std::optional<LightTree::Choice> LightTree::choose(std::span<const Emitter> emitters, const Vec3f& from,
                                                   const Vec3f& normal, double choice) const {
  double probability = 1;
  std::uint32_t at = nodes_.empty() ? IsEmitter : 0;
  while ((at & IsEmitter) == 0) {
    const Node& node = nodes_[at];
    const Importance importance(node.bounds, from, normal);
    if (!(importance.total > 0)) return std::nullopt;
    double rest = choice * importance.total;
    int child = importance.last;
    for (int i = 0; i < importance.last; ++i) {
      const double value = importance.values[i];
      if (rest < value) {
        child = i;
        break;
      }
      rest -= value;
    }
    const double value = importance.values[child];
    choice = std::clamp(rest / value, 0.0, 1 - 0x1p-53);
    probability *= value / importance.total;
    at = node.children[child];
  }
  const std::uint32_t emitter = at & ~IsEmitter;
  if (!can_illuminate(emitters[emitter], from, normal)) return std::nullopt;
  return Choice{emitter, static_cast<float>(probability)};
}

float LightTree::probability(std::span<const Emitter> emitters, const Vec3f& from, const Vec3f& normal,
                             std::uint32_t emitter) const {
  if (!can_illuminate(emitters[emitter], from, normal)) return 0;
  if (nodes_.empty()) return 1;
  double probability = 1;
  Place place = place_of_emitter_[emitter];
  for (;;) {
    const Node& node = nodes_[place.node];
    const Importance importance(node.bounds, from, normal);
    const double value = importance.values[place.child];
    if (!(value > 0)) return 0;
    probability *= value / importance.total;
    if (place.node == 0) return static_cast<float>(probability);
    place = node.parent;
  }
}

}  // namespace transport
