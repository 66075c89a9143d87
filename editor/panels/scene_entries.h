// The lines of the scene's list, as a tree of plain values.
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
  QString detail;       ///< beside the name: how many faces, how often it is used, where it is moved
  QString help;         ///< a sentence
  grf::ScenePath path;  ///< empty of a group
  std::optional<std::uint32_t> mesh;  ///< whose faces these are: an index of the scene's objects
  std::size_t observer = 0;           ///< the number of an observer in its block
  bool has_selection = false;         ///< some of its faces are selected

  SceneEntry* parent = nullptr;
  int row = 0;  ///< in the parent
  std::vector<std::unique_ptr<SceneEntry>> children;

  /// Whether it is the same line after an edit, as far as can be told.
  bool is_like(const SceneEntry& other) const { return kind == other.kind && name == other.name; }
  bool is_definition() const;
  bool can_be_renamed() const;
  SceneEntry* add(std::unique_ptr<SceneEntry> child);
  /// Sets parents and rows of the children anew.
  void number_children();
};

/// The lines of a document's scene under one that is not shown: what stands in it, as it is nested there, and
/// what it defines. A transform of one thing is a part of that thing's line.
std::unique_ptr<SceneEntry> entries_of(const Document& document);

/// The name of a mesh's line.
QString line_name_of(const grf::Mesh& mesh);
/// What is in a transform: the name of the only object, through what it is nested in, or how many.
QString contents_of(const SceneEntry& transform);

/// The icon's name for a kind.
QString icon_of(SceneEntry::Kind kind);

}  // namespace editor
