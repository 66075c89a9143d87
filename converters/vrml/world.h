#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "converters/scene_building.h"
#include "converters/vrml/appearance.h"
#include "converters/vrml/node.h"
#include "converters/vrml/polygons.h"
#include "converters/vrml/report.h"

namespace convert::vrml {

/// A parsed document with the location of its file.
struct OpenDocument {
  std::unique_ptr<const Document> document;
  std::string folder;     ///< relative to the folder of the first file
  std::string canonical;  ///< canonical path
};

/// The position of a traversal in the scene graph.
struct Place {
  unsigned depth = 0;
  std::string_view name;  ///< the nearest DEF name, of the node itself or of an ancestor
};

using Blocks = std::vector<grf::Block>;

/// Reads the blocks of all nodes in order, by the reader of either version.
template <class Reader>
Blocks read_each(Reader& reader, std::span<const Node* const> nodes, const Place& place) {
  Blocks blocks;
  for (const Node* node : nodes) {
    Blocks more = reader.read(*node, place);
    if (blocks.empty()) {
      blocks = std::move(more);
    } else {
      std::move(more.begin(), more.end(), std::back_inserter(blocks));
    }
  }
  return blocks;
}

/// The faces of a shape and their surfaces, from which a mesh is made.
struct ShapeFaces {
  Polygons polygons;
  std::vector<grf::Surface> surfaces;
};

/// The state that the readers of both versions share while they convert a file, and the files it inlines.
class World {
 public:
  World(std::string path, grf::Diagnostics& diagnostics);

  /// Converts the file to a scene; returns nothing after an error.
  std::optional<grf::Scene> read(std::shared_ptr<const Source> source);

  Report& report() { return report_; }
  Appearances& appearances() { return appearances_; }
  const std::string& path() const { return path_; }

  /// Must be called at each visited node: returns false after an error, such as a tree that is too deep or
  /// has too many nodes (since USE duplicates, a short file can expand to any number).
  bool enter(const Node& node, const Place& place);

  /// Returns the mesh of a list of nodes as a block. It is built once and instanced. Empty if it has no
  /// faces, or after an error.
  std::vector<grf::Block> mesh(const std::vector<const Node*>& made_of, const Node& shape,
                               std::string_view name,
                               const std::function<std::optional<ShapeFaces>()>& build);

  /// Puts blocks under a transform; drops them if it is singular.
  std::vector<grf::Block> under(const grf::Matrix44d& to_parent, std::vector<grf::Block> blocks,
                                const Node& node);

  /// Reads another file that a node names by URLs.
  std::vector<grf::Block> inlined(const Node& node, const std::vector<std::string>& addresses,
                                  const std::string& folder, const Place& place);

 private:
  struct SharedMesh {
    std::optional<grf::Shared<grf::Mesh>> mesh;
    grf::SourceLocation location;
    std::size_t places = 0;
  };

  const OpenDocument* open(std::shared_ptr<const Source> source, const std::string& folder);
  std::vector<grf::Block> blocks_of(const OpenDocument& document, const Place& place);
  const OpenDocument* inlined_document(const Node& node, const std::vector<std::string>& addresses,
                                       const std::string& folder);
  bool may_inline(const Node& node, const std::string& canonical);
  std::vector<grf::Definition> definitions_of_shared_meshes();
  void replace_shared_meshes(std::vector<grf::Block>& blocks) const;

  std::string path_;
  Report report_;
  DefinitionNames names_;
  Appearances appearances_;
  std::map<std::string, OpenDocument> documents_;       // by canonical path
  std::map<const Node*, const OpenDocument*> inlined_;  // by the Inline node; null: skipped
  std::vector<std::string> open_files_;                 // canonical paths, outermost first
  std::map<std::vector<const Node*>, SharedMesh> meshes_;
  std::vector<SharedMesh*> meshes_in_order_;
  std::map<const grf::Mesh*, std::string> names_of_shared_;
  std::size_t met_nodes_ = 0;
};

// These read a document of each version.
std::vector<grf::Block> read_vrml97(World& world, const OpenDocument& document, const Place& place);
std::vector<grf::Block> read_vrml1(World& world, const OpenDocument& document, const Place& place);

}  // namespace convert::vrml
