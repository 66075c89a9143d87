// Editing the vertices and faces of meshes. Where only some faces of a mesh are meant, vertices that they
// share with others are split if they come to differ, and the other faces stay as they are.
#pragma once

#include <optional>
#include <string>

#include "editor/document/face_selection.h"
#include "editor/document/scene_objects.h"
#include "grf/diagnostics.h"
#include "grf/scene.h"

namespace editor {

/// The faces of a selection in a scene, of which the objects are.
struct SelectedFaces {
  const grf::Scene& scene;
  const SceneObjects& objects;
  const FaceSelection& selection;
};

// Each gives a new scene. Nothing where a file that is included more than once would have two texts.

/// Normals of the faces' own, with creases where they are turned against each other by more than so many
/// radians (0 to pi).
std::optional<grf::Scene> with_smooth_normals(const SelectedFaces& faces, double crease,
                                              grf::Diagnostics& diagnostics);
/// Without normals.
std::optional<grf::Scene> with_flat_faces(const SelectedFaces& faces, grf::Diagnostics& diagnostics);
/// Fronts become backs, and normals point to the other side.
std::optional<grf::Scene> flipped(const SelectedFaces& faces, grf::Diagnostics& diagnostics);
/// Gives the faces' vertices a colour, or none.
std::optional<grf::Scene> with_vertex_colours(const SelectedFaces& faces, std::optional<grf::Colour> colour,
                                              grf::Diagnostics& diagnostics);
/// Gives the faces' vertices an irradiance from all directions together, in W/m2, or none.
std::optional<grf::Scene> with_irradiance(const SelectedFaces& faces, std::optional<grf::Colour> irradiance,
                                          grf::Diagnostics& diagnostics);
/// Without the faces. Meshes without faces go, and what uses them.
std::optional<grf::Scene> without_faces(const SelectedFaces& faces, grf::Diagnostics& diagnostics);

/// What the vertices of selected faces have in common.
struct CommonVertices {
  bool have_normals = false;       ///< some
  bool are_colours_mixed = false;  ///< else `colour` is that of all
  std::optional<grf::Colour> colour;
  bool are_irradiances_mixed = false;  ///< values from several directions are too
  std::optional<grf::Colour> irradiance;
};
CommonVertices common_vertices(const SceneObjects& objects, const FaceSelection& selection);

}  // namespace editor
