// Where things stand in a scene, as numbers that hold for all scenes of the same structure.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "grf/scene.h"

namespace grf {

/// The places, in the lists that lead to it, of a block or of a definition. In a scope, its definitions come
/// first, and then the blocks of its body. Of nothing: the scene itself.
using ScenePath = std::vector<std::uint32_t>;
using ScenePathView = std::span<const std::uint32_t>;

/// The block or the definition at a place; the other is null, and both are if there is nothing.
struct ScenePlace {
  Block* block = nullptr;
  Definition* definition = nullptr;
};

/// What stands at a place, to be changed. Included files on the way are copied if other scenes share them.
ScenePlace find(Scene& scene, ScenePathView path);

/// The mesh of a block, of a mesh light or of a definition, to be changed; null if there is none.
Shared<Mesh>* find_mesh(Scene& scene, ScenePathView path);

/// The blocks inside the scene, a transform, a scope or an include, to be changed; null if there are none.
BlockList* find_blocks(Scene& scene, ScenePathView path);

}  // namespace grf
