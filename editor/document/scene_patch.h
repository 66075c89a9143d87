#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
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
  /// Faces one after the other of which all had one surface, and have another one.
  struct FaceRun {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    std::uint32_t before = 0;
    std::uint32_t after = 0;
  };
  /// The meshes are two states of one, with all that it has.
  struct WholeMeshes {
    grf::Shared<grf::Mesh> before;
    grf::Shared<grf::Mesh> after;
  };
  /// Surfaces of a mesh replace others in its list, and runs of faces get other ones. Where anything else
  /// differs, it holds both states whole instead, which share their geometry with the scene.
  struct MeshPart {
    grf::ScenePath path;
    std::optional<WholeMeshes> whole;
    std::size_t first = 0;
    std::vector<grf::Surface> before;
    std::vector<grf::Surface> after;
    std::vector<FaceRun> runs;
  };
  /// Items replace others in a list, from one on: blocks, or definitions of a scope.
  template <class Item>
  struct ListPart {
    grf::ScenePath list;
    std::size_t first = 0;
    std::vector<Item> before;
    std::vector<Item> after;
  };
  using BlocksPart = ListPart<grf::Block>;
  using DefinitionsPart = ListPart<grf::Definition>;
  /// A block keeps what stands inside it, and gets other comments, transform steps or another include's name:
  /// both states hold these alone.
  struct HeadPart {
    grf::ScenePath path;
    grf::Block before;
    grf::Block after;
  };
  struct EndCommentsPart {
    grf::ScenePath list;
    std::vector<std::string> before;
    std::vector<std::string> after;
  };
  struct Part {
    bool is_included = false;  ///< it stands in a file of its own, which names others from its own place
    std::variant<MeshPart, BlocksPart, DefinitionsPart, HeadPart, EndCommentsPart> content;
  };
  class Finder;

  static void add_to(Change& change, const MeshPart& part);
  static void add_to(Change& change, const BlocksPart& part);
  static void add_to(Change& change, const DefinitionsPart& part);
  static void add_to(Change& change, const HeadPart& part);
  static void add_to(Change& change, const EndCommentsPart& part);
  static MeshPart mesh_part(grf::ScenePath path, const grf::Mesh& before, const grf::Mesh& after);
  static void put(const MeshPart& part, bool is_forward, grf::Scene& scene);
  static void put(const BlocksPart& part, bool is_forward, grf::Scene& scene);
  static void put(const DefinitionsPart& part, bool is_forward, grf::Scene& scene);
  static void put(const HeadPart& part, bool is_forward, grf::Scene& scene);
  static void put(const EndCommentsPart& part, bool is_forward, grf::Scene& scene);
  static bool continues(MeshPart& part, const MeshPart& later);
  template <class Item>
  static bool continues(ListPart<Item>& part, const ListPart<Item>& later);
  static bool continues(HeadPart& part, const HeadPart& later);
  static bool continues(EndCommentsPart& part, const EndCommentsPart& later);

  std::vector<Part> parts_;
};

}  // namespace editor
