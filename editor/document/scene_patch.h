#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "editor/document/change.h"
#include "grf/scene.h"
#include "grf/scene_path.h"

namespace editor {

/// A mesh and its path in a scene.
struct PlacedMesh {
  grf::ScenePath path;
  grf::Mesh mesh;
};

namespace patch {

/// Replaces consecutive items of a list: blocks, end comments, definitions of a scope, surfaces of a mesh.
template <class Item>
struct ListPart {
  grf::ScenePath path;  ///< of the owner of the list
  std::size_t first = 0;
  std::vector<Item> before;
  std::vector<Item> after;
};
/// A block keeps its children, and gets other comments, transform steps or another include's name: both
/// states store only these.
struct HeadPart : ListPart<grf::Block> {};
/// A run of consecutive faces that all had one surface, and get another one.
struct FaceRun {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  std::uint32_t before = 0;
  std::uint32_t after = 0;
};
/// Replaces surfaces of a mesh, and the surface of runs of faces.
struct SurfacesPart : ListPart<grf::Surface> {
  std::vector<FaceRun> runs;
};
/// Stores both states of a mesh whole if anything else differs; they share their geometry with the scene.
struct MeshPart {
  grf::ScenePath path;
  grf::Shared<grf::Mesh> before;
  grf::Shared<grf::Mesh> after;
};
struct Part {
  bool is_included = false;  ///< it is in an included file, to which its file names are relative
  std::variant<SurfacesPart, MeshPart, ListPart<grf::Block>, ListPart<grf::Definition>, HeadPart,
               ListPart<std::string>>
      content;
};

}  // namespace patch

/// The difference between two states of a scene, which converts either into the other. It stores only what
/// differs, so that a long undo history needs little memory.
class ScenePatch {
 public:
  /// Compares two scenes; parts that both share are skipped.
  static ScenePatch between(const grf::Scene& before, const grf::Scene& after);
  /// The patch from a scene to the one with these meshes in place of those at their paths.
  static ScenePatch of_meshes(const grf::Scene& before, const std::vector<PlacedMesh>& after);

  bool empty() const { return parts_.empty(); }
  void apply(grf::Scene& before) const;
  void revert(grf::Scene& after) const;

  /// Which kinds of things differ; `meshes` tells which meshes do.
  Change change() const;
  /// The paths of the meshes whose surfaces differ.
  std::set<grf::ScenePath> meshes() const;

  /// Appends a patch that starts where this one ends.
  void append(const ScenePatch& later);
  /// Makes file names relative to another path, see `grf::relocate`.
  void relocate(const std::string& from, const std::string& to,
                const std::map<std::string, std::string>& moved);

 private:
  std::vector<patch::Part> parts_;
};

}  // namespace editor
