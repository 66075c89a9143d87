// Summarises the surfaces of the selected faces for the rows of the Surface dock.
#pragma once

#include <QString>
#include <QStringList>
#include <cstddef>
#include <vector>

#include "editor/document/document.h"
#include "editor/document/geometry_edits.h"

namespace editor {

struct SelectionSummary {
  std::size_t faces = 0;
  double area = 0;  ///< world space, m2
  bool are_all_of_mesh_lights = false;
  std::vector<grf::ScenePath> meshes;  ///< meshes with selected faces
  CommonSurface surface;
  CommonVertices vertices;
  // Names that refer to the same definition in all of these meshes.
  QStringList brdfs, pdfs, colours, textures;
};

/// Computes the summary, in some milliseconds for a large mesh.
SelectionSummary summary_of(const Document& document);

/// The meshes that have selected faces.
std::vector<grf::ScenePath> selected_meshes(const Document& document);

/// Why a row is disabled for the faces; empty if it is enabled.
QString why_not_reflecting(const SelectionSummary& summary);

/// The text of fields whose values differ among the faces.
inline QString mixed_text() { return QStringLiteral("mixed"); }

}  // namespace editor
