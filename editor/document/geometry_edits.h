// Geometry edits change the vertices and faces of a mesh. If only some faces of a mesh are selected, vertices
// shared with others are split where they come to differ, and the other faces are unchanged.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
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

/// The faces of a scene that can be edited synchronously, without a noticeable delay; more need a job.
inline constexpr std::size_t FewFaces = 20'000;

/// Selected faces of a scene, with the scene's objects.
struct SelectedFaces {
  const grf::Scene& scene;
  const SceneObjects& objects;
  const FaceSelection& selection;
};

// Each returns a new scene, in which the faces are edited at all places that include their file.

/// Edits a mesh of only the selected faces of a mesh object, whose index is the second argument. The edit
/// keeps number and order of the faces.
using FaceEdit = std::function<grf::Mesh(const grf::Mesh& faces, std::uint32_t mesh)>;
grf::Scene with_edited_faces(const SelectedFaces& faces, const FaceEdit& edit);
/// Recomputes the faces' vertex normals, with creases at edges whose face angle exceeds `crease` radians (0
/// to pi).
grf::Scene with_smooth_normals(const SelectedFaces& faces, double crease);
/// Removes the faces' vertex normals (flat shading).
grf::Scene with_flat_faces(const SelectedFaces& faces);
/// Reverses the orientation and the normals of the faces.
grf::Scene flipped(const SelectedFaces& faces);
/// Makes the faces of the meshes of these faces agree in their orientation and point outward, see
/// `convert::inward_faces`.
grf::Scene with_outward_faces(const SelectedFaces& faces);
/// The faces that this would reverse, of the meshes of these faces.
FaceSelection inward_faces(const SelectedFaces& faces);
/// Sets or removes the colour of the faces' vertices.
grf::Scene with_vertex_colours(const SelectedFaces& faces, std::optional<grf::Colour> colour);
/// Sets or removes the irradiance of the faces' vertices, from all directions together, in W/m2.
grf::Scene with_irradiance(const SelectedFaces& faces, std::optional<grf::Colour> irradiance);
/// Subdivides the meshes of these faces, see `convert::subdivided`.
grf::Scene with_subdivided_meshes(const SelectedFaces& faces, const convert::Subdivision& subdivision);
/// The total number of faces of those meshes after subdivision.
double faces_after(const SelectedFaces& faces, const convert::Subdivision& subdivision);
/// Smooths the meshes of these faces, see `convert::smoothed`.
grf::Scene with_smooth_meshes(const SelectedFaces& faces, int steps);
/// Deletes the faces, meshes without faces, and what uses them.
grf::Scene without_faces(const SelectedFaces& faces);

/// The vertex attributes that all selected faces share.
struct CommonVertices {
  bool have_normals = false;  ///< at least one
  CommonValue<grf::Colour> colour;
  CommonValue<grf::Colour> irradiance;  ///< mixed also if there are values from several directions
};
CommonVertices common_vertices(const SceneObjects& objects, const FaceSelection& selection);

}  // namespace editor
