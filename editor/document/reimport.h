// Reads a model again that was imported, and keeps what was assigned to its faces.
#pragma once

#include <QString>
#include <QStringList>
#include <vector>

#include "grf/scene.h"
#include "grf/scene_path.h"

namespace editor {

/// Writes a comment in front of each mesh of an imported scene, which says from which file and object it
/// came:
/// `//imported "seat" from "/models/chair.obj"`. Comments stay with their mesh wherever it is moved, and in
/// the file.
void mark_imported(grf::Scene& scene, const QString& file);

/// The file from which the mesh at a path was imported, or the first mesh inside it; empty if there is none.
QString import_source(const grf::Scene& scene, grf::ScenePathView path);

/// A scene whose imported meshes have new geometry.
struct Reimported {
  grf::Scene scene;
  std::size_t meshes = 0;  ///< with new geometry
  QStringList problems;    ///< what no longer fits, a line each
};

/// Gives all meshes that were imported from a file the geometry of the objects with their names in a model
/// that was read from it again. Faces keep their surfaces by their order: further faces have that of the mesh
/// itself. A mesh whose object is gone stays as it is. Irradiance is kept if the number of vertices is the
/// same.
Reimported reimported(const grf::Scene& scene, const QString& file, const grf::Scene& model);

}  // namespace editor
