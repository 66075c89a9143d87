// Paths to blocks and definitions in a scene graph, as indices that are valid for all scenes of the same
// structure.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "grf/scene.h"

namespace grf {

/// The path to a block or a definition: an index per level. In a scope, its definitions come first, then the
/// blocks of its body. An empty path is the scene itself.
using ScenePath = std::vector<std::uint32_t>;
using ScenePathView = std::span<const std::uint32_t>;

/// The block or the definition at a path; the other is null, and both are if the path leads nowhere.
struct ScenePlace {
  Block* block = nullptr;
  Definition* definition = nullptr;
};

/// Finds the block or definition at a path, to modify it. Shared included files on the way are copied.
ScenePlace find(Scene& scene, ScenePathView path);

/// Finds the mesh of a block, of a mesh light or of a definition, to modify it; null if there is none.
Shared<Mesh>* find_mesh(Scene& scene, ScenePathView path);

/// Finds the blocks of the scene, a transform, a scope or an include, to modify them; null if there are none.
BlockList* find_blocks(Scene& scene, ScenePathView path);

}  // namespace grf
