// What holds at a place of a scene, and putting things there or taking them away.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "editor/document/face_selection.h"
#include "grf/diagnostics.h"
#include "grf/math.h"
#include "grf/scene.h"
#include "grf/scene_path.h"

namespace editor {

/// A definition and where it stands. The pointer is into the scene, good until that is changed.
struct PlacedDefinition {
  grf::ScenePath path;
  const grf::Definition* definition = nullptr;
};

/// The definitions that names mean at a place, where inner ones hide outer ones; the outermost first.
std::vector<PlacedDefinition> definitions_at(const grf::Scene& scene, grf::ScenePathView path);

/// Those that mean the same at all places. What is nearer to one of them than to the others is not there.
std::vector<PlacedDefinition> common_definitions(const grf::Scene& scene,
                                                 const std::vector<grf::ScenePath>& paths);

/// What stands at a place, or null.
const grf::Definition* definition_at(const grf::Scene& scene, grf::ScenePathView path);
const grf::Block* block_at(const grf::Scene& scene, grf::ScenePathView path);
/// The mesh of a block, of a mesh light or of a definition, or null.
const grf::Mesh* mesh_at(const grf::Scene& scene, grf::ScenePathView path);
/// Returns the content at a path, to be changed, or null if that is of another kind.
template <class Content>
Content* content_at(grf::Scene& scene, grf::ScenePathView path) {
  const grf::ScenePlace place = grf::find(scene, path);
  return place.block == nullptr ? nullptr : std::get_if<Content>(&place.block->content);
}
/// Whether a place is in an included file.
bool is_in_include(const grf::Scene& scene, grf::ScenePathView path);

/// From the coordinates in which what stands at the place is given to the world's; without the steps of the
/// transform that stands there itself.
grf::Matrix44d to_world_at(const grf::Scene& scene, grf::ScenePathView path);

/// Puts a definition behind those of a scope. Paths are those of before; `shifted` has them as they are then.
class DefinitionInsertion {
 public:
  /// Into the innermost scope around the place, in the same file.
  static DefinitionInsertion around(const grf::Scene& scene, grf::ScenePathView path);
  /// Into the scope around the whole scene.
  static DefinitionInsertion outermost(const grf::Scene& scene);

  void apply(grf::Scene& scene, grf::Definition definition) const;
  grf::ScenePath shifted(grf::ScenePath path) const;
  /// Of the definition, once it is there.
  grf::ScenePath definition_path() const;

 private:
  grf::ScenePath scope_;           // of a block that is a scope; empty: a new one around the list of blocks
  grf::ScenePath list_;            // whose blocks the new scope holds
  std::uint32_t definitions_ = 0;  // that the scope has
  bool is_new_ = false;
};

/// Takes blocks and definitions away, and transforms of which nothing is left. No path leads to nothing.
void erase(grf::Scene& scene, std::vector<grf::ScenePath> paths);

/// The list to which new things of the scene go: inside the scope around the whole scene, if there is one.
grf::BlockList& outermost_blocks(grf::Scene& scene);

/// Calls an action with each include among blocks, but with none inside of another. `List` is const or not.
template <class List, class Action>
void for_each_include(List& list, const Action& action) {
  for (auto& block : list.blocks) {
    if (auto* include = std::get_if<grf::Include>(&block.content)) action(*include);
    if (auto* transform = std::get_if<grf::Transform>(&block.content)) {
      for_each_include(transform->body, action);
    } else if (auto* scope = std::get_if<grf::DefinitionScope>(&block.content)) {
      for_each_include(scope->body, action);
    }
  }
}

/// How often each file is included that was read, also by other included files; by its canonical path.
std::map<std::string, std::size_t> included_files(const grf::Scene& scene);

/// Carries what an edit changed in a file that is included at several places to all of them, and returns of
/// how many others. An error where two places were changed in different ways: a file has one text.
std::size_t edit_all_places(const grf::Scene& before, grf::Scene& after, grf::Diagnostics& diagnostics);

/// The faces of a selection, and the same ones at all places where their file is included.
FaceSelection at_all_places(const grf::Scene& scene, const SceneObjects& objects,
                            const FaceSelection& selection);

/// The block, definition or faces' mesh that was written at a location or nearest before it in the same
/// file, if there is one.
std::optional<grf::ScenePath> written_at(const grf::Scene& scene, const grf::SourceLocation& location);

}  // namespace editor
