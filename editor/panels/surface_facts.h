// What the rows of the surface panel show: all that is common to the selected faces.
#pragma once

#include <QString>
#include <QStringList>
#include <cstddef>
#include <vector>

#include "editor/document/document.h"
#include "editor/document/geometry_edits.h"

namespace editor {

struct SurfaceFacts {
  std::size_t faces = 0;
  double area = 0;  ///< in the world, m2
  bool are_all_of_mesh_lights = false;
  std::vector<grf::ScenePath> meshes;  ///< with selected faces
  CommonSurface surface;
  CommonVertices vertices;
  // Names that mean the same for all of these meshes.
  QStringList brdfs, pdfs, colours, textures;
};

/// Takes some milliseconds for a large mesh.
SurfaceFacts facts_of(const Document& document);

/// Those with selected faces.
std::vector<grf::ScenePath> selected_meshes(const Document& document);

/// Why a row cannot be used for the faces; empty: it can.
QString why_not_reflecting(const SurfaceFacts& facts);

/// What stands in fields whose faces differ.
inline QString mixed_text() { return QStringLiteral("mixed"); }

}  // namespace editor
