// Readers compose scenes by these functions, and writers decompose them.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "grf/scene.h"
#include "grf/unique_names.h"

namespace convert {

/// Makes a scene of blocks in the scope of definitions, all with the same location.
grf::Scene scene_of(std::vector<grf::Definition> definitions, std::vector<grf::Block> blocks,
                    const grf::SourceLocation& location);

/// Puts blocks under a transform, unless it is the identity.
std::vector<grf::Block> placed(std::vector<grf::Block> blocks, const grf::Matrix44d& to_parent,
                               const grf::SourceLocation& location);

/// Decomposes an invertible affine matrix into transform steps, to float precision: one step if one suffices,
/// else rotation, scale, rotation and translation (a singular value decomposition), so that shears are kept.
std::vector<grf::TransformStep> transform_steps(const grf::Matrix44d& matrix);

/// Returns the bounds of the meshes of a scene, except in included files.
grf::Box3d bounds_of(const grf::Scene& scene);

/// Calls a function for each mesh and mesh light of the blocks and of their definitions, except in included
/// files.
void for_each_mesh(grf::BlockList& list, const std::function<void(grf::Shared<grf::Mesh>&)>& action);

/// Removes the meshes and mesh lights for which `keeps` is false, with their instances and the transforms
/// that are empty then. Calls it in the order of `for_each_mesh`.
void keep_meshes(grf::BlockList& list, const std::function<bool(const grf::Mesh&)>& keeps);

/// Returns the name of what comes from a file that gives it none: the file's name without folder and
/// extension, in UTF-8 on one line.
std::string name_of_file(const std::string& path);

/// Names the nameless meshes of an imported scene, which has no mesh lights, after its file: `chair`, then
/// `chair_2` and so on, skipping names that the scene has.
void name_meshes(grf::Scene& scene, const std::string& path);

/// Makes unique names for the definitions of a scene.
class DefinitionNames {
 public:
  /// Returns `to_identifier` of the name, with the suffix `_2`, `_3` and so on if it was taken before.
  std::string take(std::string_view name);

 private:
  grf::UniqueNames names_;
};

}  // namespace convert
