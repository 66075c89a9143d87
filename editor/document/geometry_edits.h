// Editing the vertices and faces of meshes. Where only some faces of a mesh are meant, vertices that they
// share with others are split if they come to differ, and the other faces stay as they are.
#pragma once

#include <optional>

#include "editor/document/face_selection.h"
#include "editor/document/scene_objects.h"
#include "editor/document/surface_edits.h"
#include "grf/diagnostics.h"
#include "grf/scene.h"

namespace convert {
struct Subdivision;
}

namespace editor {

/// The faces of a selection in a scene, of which the objects are.
struct SelectedFaces {
  const grf::Scene& scene;
  const SceneObjects& objects;
  const FaceSelection& selection;
};

// Each gives a new scene, in which the faces are edited at all places where their file is included.

/// Normals of the faces' own, with creases where they are turned against each other by more than so many
/// radians (0 to pi).
grf::Scene with_smooth_normals(const SelectedFaces& faces, double crease);
/// Without normals.
grf::Scene with_flat_faces(const SelectedFaces& faces);
/// Fronts become backs, and normals point to the other side.
grf::Scene flipped(const SelectedFaces& faces);
/// Gives the faces' vertices a colour, or none.
grf::Scene with_vertex_colours(const SelectedFaces& faces, std::optional<grf::Colour> colour);
/// Gives the faces' vertices an irradiance from all directions together, in W/m2, or none.
grf::Scene with_irradiance(const SelectedFaces& faces, std::optional<grf::Colour> irradiance);
/// With all faces of the meshes of these faces subdivided, see `convert::subdivided`.
grf::Scene with_subdivided_meshes(const SelectedFaces& faces, const convert::Subdivision& subdivision);
/// How many faces those meshes will have together.
double faces_after(const SelectedFaces& faces, const convert::Subdivision& subdivision);
/// With the meshes of these faces smoothed, see `convert::smoothed`.
grf::Scene with_smooth_meshes(const SelectedFaces& faces, int steps);
/// Without the faces. Meshes without faces go, and what uses them.
grf::Scene without_faces(const SelectedFaces& faces);

/// What the vertices of selected faces have in common.
struct CommonVertices {
  bool have_normals = false;  ///< some
  CommonValue<grf::Colour> colour;
  CommonValue<grf::Colour> irradiance;  ///< mixed too where values are from several directions
};
CommonVertices common_vertices(const SceneObjects& objects, const FaceSelection& selection);

}  // namespace editor
