#include "grf/scene_path.h"

#include <variant>

namespace grf {
namespace {

/// The state of following a path.
struct Step {
  BlockList* blocks = nullptr;             ///< indexed by the next number of the path
  DefinitionScope* definitions = nullptr;  ///< counted before the blocks if they are a scope's
  ScenePlace place;
};

Step inside(Block& block) {
  Step step;
  step.place.block = &block;
  if (auto* transform = std::get_if<Transform>(&block.content)) {
    step.blocks = &transform->body;
  } else if (auto* include = std::get_if<Include>(&block.content)) {
    step.blocks = &include->contents.edit();
  } else if (auto* scope = std::get_if<DefinitionScope>(&block.content)) {
    step.blocks = &scope->body;
    step.definitions = scope;
  }
  return step;
}

Step follow(const Step& step, std::size_t number) {
  if (step.blocks == nullptr) return {};
  if (step.definitions != nullptr) {
    auto& definitions = step.definitions->definitions;
    if (number < definitions.size()) {
      Step found;
      found.place.definition = &definitions[number];
      return found;
    }
    number -= definitions.size();
  }
  return number < step.blocks->blocks.size() ? inside(step.blocks->blocks[number]) : Step();
}

Step follow(Scene& scene, ScenePathView path) {
  Step step;
  step.blocks = &scene.contents;
  for (const std::uint32_t number : path) step = follow(step, number);
  return step;
}

}  // namespace

ScenePlace find(Scene& scene, ScenePathView path) { return follow(scene, path).place; }

Shared<Mesh>* find_mesh(Scene& scene, ScenePathView path) {
  const ScenePlace place = find(scene, path);
  if (place.definition != nullptr) return std::get_if<Shared<Mesh>>(&place.definition->body);
  if (place.block == nullptr) return nullptr;
  if (auto* light = std::get_if<MeshLight>(&place.block->content)) return &light->mesh;
  return std::get_if<Shared<Mesh>>(&place.block->content);
}

BlockList* find_blocks(Scene& scene, ScenePathView path) { return follow(scene, path).blocks; }

}  // namespace grf
