// Looks up and edits a scene at paths: definitions in scope, insertion and deletion.
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

/// A definition and its path. The pointer is into the scene, valid until that is changed.
struct PlacedDefinition {
  grf::ScenePath path;
  const grf::Definition* definition = nullptr;
};

/// The definitions in scope at a path, where inner ones hide outer ones; the outermost first.
std::vector<PlacedDefinition> definitions_at(const grf::Scene& scene, grf::ScenePathView path);

/// The definitions in scope with the same meaning at all paths.
std::vector<PlacedDefinition> common_definitions(const grf::Scene& scene,
                                                 const std::vector<grf::ScenePath>& paths);

/// The definition at a path, or null.
const grf::Definition* definition_at(const grf::Scene& scene, grf::ScenePathView path);
const grf::Block* block_at(const grf::Scene& scene, grf::ScenePathView path);
/// The mesh of a block, of a mesh light or of a definition, or null.
const grf::Mesh* mesh_at(const grf::Scene& scene, grf::ScenePathView path);
/// Returns the mutable content at a path, or null if it is of another kind.
template <class Content>
Content* content_at(grf::Scene& scene, grf::ScenePathView path) {
  const grf::ScenePlace place = grf::find(scene, path);
  return place.block == nullptr ? nullptr : std::get_if<Content>(&place.block->content);
}
/// Whether a path is another one, or leads from there to something inside.
bool is_inside(grf::ScenePathView path, grf::ScenePathView outer);
/// Whether a path leads into an included file.
bool is_in_include(const grf::Scene& scene, grf::ScenePathView path);

/// The matrix from the local coordinates at a path to world space; without the steps of a transform that is
/// at the path itself.
grf::Matrix44d to_world_at(const grf::Scene& scene, grf::ScenePathView path);

/// Appends a definition to those of a scope. Paths are those before the insertion; `shifted` converts them to
/// those after it.
class DefinitionInsertion {
 public:
  /// Into the innermost scope around the path, in the same file.
  static DefinitionInsertion around(const grf::Scene& scene, grf::ScenePathView path);
  /// Into the scope around the whole scene.
  static DefinitionInsertion outermost(const grf::Scene& scene);

  void apply(grf::Scene& scene, grf::Definition definition) const;
  grf::ScenePath shifted(grf::ScenePath path) const;
  /// The path of the definition after the insertion.
  grf::ScenePath definition_path() const;

 private:
  grf::ScenePath scope_;           // of a block that is a scope; empty: a new one around the list of blocks
  grf::ScenePath list_;            // whose blocks the new scope holds
  std::uint32_t definitions_ = 0;  // that the scope has
  bool is_new_ = false;
};

/// Removes blocks and definitions, and transforms that become empty. All paths must be valid.
void erase(grf::Scene& scene, std::vector<grf::ScenePath> paths);

/// The list to which new objects of the scene are added: inside the scope around the whole scene, if there is
/// one.
grf::BlockList& outermost_blocks(grf::Scene& scene);

/// Calls an action for each include among blocks, except for nested ones. `List` may be const.
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

/// The number of includes of each file that was read, also by other included files; by canonical path.
std::map<std::string, std::size_t> included_files(const grf::Scene& scene);

/// Applies the edits of a file that is included at several places to all of them, and returns the number of
/// the others. Reports an error if two places were edited differently: a file has one text.
std::size_t edit_all_places(const grf::Scene& before, grf::Scene& after, grf::Diagnostics& diagnostics);

/// Extends a selection to the same faces at all places that include their file.
FaceSelection at_all_places(const grf::Scene& scene, const SceneObjects& objects,
                            const FaceSelection& selection);

/// The path of the block, definition or faces' mesh that was written at a location, or nearest before it in
/// the same file, if any.
std::optional<grf::ScenePath> written_at(const grf::Scene& scene, const grf::SourceLocation& location);

}  // namespace editor
