// What readers make a scene of, and writers take it apart to.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "grf/scene.h"
#include "grf/unique_names.h"

namespace convert {

/// The blocks in the scope of the definitions, all from one place.
grf::Scene scene_of(std::vector<grf::Definition> definitions, std::vector<grf::Block> blocks,
                    const grf::SourceLocation& location);

/// The blocks under a transform: themselves if it is the identity.
std::vector<grf::Block> placed(std::vector<grf::Block> blocks, const grf::Matrix44d& to_parent,
                               const grf::SourceLocation& location);

/// Steps that together are the matrix, which is affine and has an inverse, as near as floats come: one where
/// one does, else rotation, scale, rotation and translation, so that shears are kept too.
std::vector<grf::TransformStep> transform_steps(const grf::Matrix44d& matrix);

/// Does something with each mesh and mesh light of the blocks and of their definitions. Included files stay
/// as they are.
void for_each_mesh(grf::BlockList& list, const std::function<void(grf::Shared<grf::Mesh>&)>& action);

/// Gives each thing of a file a name of its own among the definitions of a scene.
class DefinitionNames {
 public:
  /// `to_identifier` of the name; with `_2`, `_3` and so on behind it where that was taken before.
  std::string take(std::string_view name);

 private:
  grf::UniqueNames names_;
};

}  // namespace convert
