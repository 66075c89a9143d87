// Moves objects in the scene graph: to other places of the list of objects, into groups and out of them.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "editor/document/object_placement.h"
#include "grf/diagnostics.h"
#include "grf/scene.h"
#include "grf/scene_path.h"

namespace editor {

/// A place between the blocks of the scene, of a transform or of a scope.
struct BlockPlace {
  grf::ScenePath list;       ///< of the owner of the blocks; empty for the scene itself
  std::uint32_t before = 0;  ///< the last index of the path of the block that follows; or that of the end

  /// The path of a block that is inserted there.
  grf::ScenePath path() const;
};

/// The place in front of a block, with the transform that moves only this block.
BlockPlace place_before(const grf::Scene& scene, grf::ScenePathView block);
/// The place behind it.
BlockPlace place_after(const grf::Scene& scene, grf::ScenePathView block);
/// The place behind all blocks of a transform, or of the scene if the path is empty.
BlockPlace place_at_end(const grf::Scene& scene, grf::ScenePathView list);

// Each returns the edited scene with the paths of the objects in it, or nothing with the reason in the
// diagnostics. An object of an included file moves with its include.

/// Moves objects, in their order in the scene, to another place. They keep their place in world space, as
/// steps of their own transforms; moving them back restores the same numbers if the transforms on the way are
/// translations. Fails if an object would be inside itself or in an included file, or if a name that it uses
/// has another meaning there.
std::optional<TransformedObjects> move_objects(const grf::Scene& scene,
                                               const std::vector<grf::ScenePath>& paths,
                                               const BlockPlace& place, grf::Diagnostics& diagnostics);

/// Moves each object by one place among its siblings, up if `step` is -1 and down if it is 1. Those at the
/// end of their list stay, and so do those behind them.
TransformedObjects shift_objects(const grf::Scene& scene, const std::vector<grf::ScenePath>& paths, int step);

/// Moves objects out of the innermost group that contains the last of them, behind that group.
std::optional<TransformedObjects> move_out_of_group(const grf::Scene& scene,
                                                    const std::vector<grf::ScenePath>& paths,
                                                    grf::Diagnostics& diagnostics);

/// Moves objects to the end of the group in front of the first of those beside the last one.
std::optional<TransformedObjects> move_into_group(const grf::Scene& scene,
                                                  const std::vector<grf::ScenePath>& paths,
                                                  grf::Diagnostics& diagnostics);

/// Moves two or more objects into a new transform, at the place of the first of those beside the last one.
/// The path is that of the transform.
std::optional<TransformedObjects> group_objects(const grf::Scene& scene,
                                                const std::vector<grf::ScenePath>& paths,
                                                grf::Diagnostics& diagnostics);

/// Replaces transforms by their children, which keep their place in world space.
std::optional<TransformedObjects> ungroup_objects(const grf::Scene& scene,
                                                  const std::vector<grf::ScenePath>& paths,
                                                  grf::Diagnostics& diagnostics);

/// Inserts an instance of the mesh that is defined at a path. Fails if its name has another meaning there.
std::optional<TransformedObjects> use_definition(const grf::Scene& scene, grf::ScenePathView definition,
                                                 const BlockPlace& place, grf::Diagnostics& diagnostics);

}  // namespace editor
