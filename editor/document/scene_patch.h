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

/// A mesh, and where it stands in a scene.
struct PlacedMesh {
  grf::ScenePath path;
  grf::Mesh mesh;
};

namespace patch {

/// Items replace others in a list, from one on: blocks, end comments, definitions of a scope, surfaces of a
/// mesh.
template <class Item>
struct ListPart {
  grf::ScenePath path;  ///< of what holds the list
  std::size_t first = 0;
  std::vector<Item> before;
  std::vector<Item> after;
};
/// A block keeps what stands inside it, and gets other comments, transform steps or another include's name:
/// both states hold these alone.
struct HeadPart : ListPart<grf::Block> {};
/// Faces one after the other of which all had one surface, and have another one.
struct FaceRun {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  std::uint32_t before = 0;
  std::uint32_t after = 0;
};
/// Surfaces of a mesh replace others, and runs of faces get other ones.
struct SurfacesPart : ListPart<grf::Surface> {
  std::vector<FaceRun> runs;
};
/// Where anything else of a mesh differs, both states are held whole, which share their geometry with the
/// scene.
struct MeshPart {
  grf::ScenePath path;
  grf::Shared<grf::Mesh> before;
  grf::Shared<grf::Mesh> after;
};
struct Part {
  bool is_included = false;  ///< it stands in a file of its own, which names others from its own place
  std::variant<SurfacesPart, MeshPart, ListPart<grf::Block>, ListPart<grf::Definition>, HeadPart,
               ListPart<std::string>>
      content;
};

}  // namespace patch

/// The difference between two states of a scene, which leads from each of them to the other. It holds what
/// differs alone, so that a long history of steps needs little memory.
class ScenePatch {
 public:
  /// Parts that both scenes share are not compared.
  static ScenePatch between(const grf::Scene& before, const grf::Scene& after);
  /// From a scene to that in which these meshes stand at their places, where there are meshes already.
  static ScenePatch of_meshes(const grf::Scene& before, const std::vector<PlacedMesh>& after);

  bool empty() const { return parts_.empty(); }
  void apply(grf::Scene& before) const;
  void revert(grf::Scene& after) const;

  /// The change says what kinds of things differ; which meshes do, `meshes` says.
  Change change() const;
  /// The places of the meshes that differ in what their faces have.
  std::set<grf::ScenePath> meshes() const;

  /// Takes up a patch that leads on from where this one leads to.
  void append(const ScenePatch& later);
  /// Names files from another path, see `grf::relocate`.
  void relocate(const std::string& from, const std::string& to,
                const std::map<std::string, std::string>& moved);

 private:
  std::vector<patch::Part> parts_;
};

}  // namespace editor
