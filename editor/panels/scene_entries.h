// The scene outliner shows a tree of entries, which are plain values.
#pragma once

#include <QString>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "editor/document/document.h"
#include "grf/scene_path.h"

namespace editor {

struct SceneEntry {
  enum class Kind {
    Group,
    Mesh,
    MeshLight,
    AreaLight,
    Instance,
    Transform,
    Include,
    Observer,
    Brdf,
    Pdf,
    Colour,
    Texture,
    DefinedMesh
  };

  Kind kind = Kind::Group;
  QString name;
  QString detail;       ///< text beside the name: number of faces, number of uses, or translation
  QString help;         ///< tool tip, a sentence
  grf::ScenePath path;  ///< empty for a group
  std::optional<std::uint32_t> mesh;  ///< the mesh of these faces: an index into the scene's objects
  std::size_t faces = 0;              ///< of that mesh; of a group, of all items in it
  std::size_t observer = 0;           ///< number of an observer in its block
  bool has_selection = false;         ///< whether some of its faces are selected

  SceneEntry* parent = nullptr;
  int row = 0;  ///< row in the parent
  std::vector<std::unique_ptr<SceneEntry>> children;

  /// Whether this is probably the same item after an edit.
  bool is_like(const SceneEntry& other) const { return kind == other.kind && name == other.name; }
  bool is_definition() const;
  bool can_be_renamed() const;
  /// Whether it is a block of the scene, and neither a group of items nor a definition.
  bool is_object() const { return kind != Kind::Group && !is_definition(); }
  SceneEntry* add(std::unique_ptr<SceneEntry> child);
  /// Updates parent and row of the children.
  void number_children();
};

/// Builds the items of a document's scene under an invisible root: its objects, nested as in the scene graph,
/// and its definitions. A transform with a single child is merged with the item of that child.
std::unique_ptr<SceneEntry> entries_of(const Document& document);

/// The display name of a mesh.
QString display_name_of(const grf::Mesh& mesh);
/// Summarises the contents of a transform: the name of its only object, however deep, or the numbers of
/// objects and of faces.
QString contents_of(const SceneEntry& transform);

/// The name of the icon for a kind.
QString icon_of(SceneEntry::Kind kind);

}  // namespace editor
