#include "editor/document/geometry_edits.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <set>
#include <utility>
#include <variant>
#include <vector>

#include "converters/mesh_operations/normals.h"
#include "converters/mesh_operations/orient.h"
#include "converters/mesh_operations/rebuild.h"
#include "converters/mesh_operations/smooth.h"
#include "converters/mesh_operations/subdivide.h"
#include "editor/document/scene_places.h"
#include "grf/scene_path.h"
#include "grf/visit.h"

namespace editor {
namespace {

std::vector<std::uint32_t> numbers_of(const FaceSelection::Faces& faces) {
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t face = 0; face < faces.size(); ++face) {
    if (faces[face]) numbers.push_back(face);
  }
  return numbers;
}

/// Replaces the vertices of some faces of a mesh by those of a part, which has these faces in the same order.
grf::Mesh with_part(const grf::Mesh& mesh, const FaceSelection::Faces& faces, const grf::Mesh& part) {
  grf::MeshDraft vertices_of_both(mesh);
  std::vector<std::uint32_t> copies;
  const std::size_t count = part.geometry->positions.size();
  copies.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) copies.push_back(vertices_of_both.copy_vertex(part, i));
  const grf::Mesh both(std::move(vertices_of_both));
  const std::vector<std::uint32_t> first = convert::first_equal_vertex(both);
  convert::Rebuild rebuild(both);
  std::vector<std::uint32_t> corners;
  std::size_t of_part = 0;
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    corners.clear();
    if (faces[face]) {
      for (const std::uint32_t corner : part.face(of_part)) corners.push_back(first[copies[corner]]);
      ++of_part;
    } else {
      for (const std::uint32_t corner : mesh.face(face)) corners.push_back(first[corner]);
    }
    rebuild.add_face(corners, (*mesh.surface_of_face)[face]);
  }
  return rebuild.take();
}

using MeshEdit = std::function<grf::Mesh(const grf::Mesh&)>;

grf::Scene edited_scene(const SelectedFaces& faces, const MeshEdit& edit) {
  return with_edited_faces(faces, [&edit](const grf::Mesh& mesh, std::uint32_t) { return edit(mesh); });
}

/// Edits whole meshes of a scene, which may have other faces afterwards.
grf::Scene with_edited_meshes(const SelectedFaces& faces, const MeshEdit& edit) {
  grf::Scene scene = faces.scene;
  for (const std::uint32_t i : at_all_places(faces.scene, faces.objects, faces.selection).meshes()) {
    const MeshObject& object = faces.objects.meshes[i];
    *grf::find_mesh(scene, object.path) = edit(*object.mesh);
  }
  return scene;
}

grf::Mesh flipped_mesh(const grf::Mesh& mesh) {
  grf::MeshDraft flipped(mesh);
  for (std::size_t face = 0; face < flipped.face_count(); ++face) flipped.reverse_face(face);
  for (std::size_t i = 0; i < flipped.positions.size(); ++i) {
    if (flipped.normals.has(i)) flipped.normals.set(i, -flipped.normals[i]);
  }
  return flipped;
}

template <class Value>
grf::OptionalVertexValues<Value> same_at_all(std::size_t vertices, const std::optional<grf::Colour>& value) {
  grf::OptionalVertexValues<Value> values;
  if (!value) return values;
  values.reserve(vertices);
  for (std::size_t i = 0; i < vertices; ++i) values.set(i, *value);
  return values;
}

/// All `use` blocks of the definitions at these paths.
std::vector<grf::ScenePath> uses_of(const grf::Scene& scene, const std::vector<grf::ScenePath>& paths) {
  std::set<const grf::Definition*> definitions;
  for (const grf::ScenePath& path : paths) {
    if (const grf::Definition* definition = definition_at(scene, path)) definitions.insert(definition);
  }
  std::vector<grf::ScenePath> uses;
  grf::SceneVisitor visitor;
  visitor.use = [&](const grf::Use& use, const grf::Placement& placement, const grf::Block&) {
    if (definitions.contains(placement.scope.find(use.mesh.name))) {
      uses.emplace_back(placement.path.begin(), placement.path.end());
    }
  };
  grf::visit(scene, visitor);
  return uses;
}

}  // namespace

grf::Scene with_edited_faces(const SelectedFaces& faces, const FaceEdit& edit) {
  grf::Scene scene = faces.scene;
  const FaceSelection selection = at_all_places(faces.scene, faces.objects, faces.selection);
  for (const std::uint32_t i : selection.meshes()) {
    const FaceSelection::Faces& of_mesh = selection.of_mesh(i);
    const MeshObject& object = faces.objects.meshes[i];
    const grf::Mesh& mesh = *object.mesh;
    *grf::find_mesh(scene, object.path) =
        of_mesh.all() ? edit(mesh, i)
                      : with_part(mesh, of_mesh, edit(grf::submesh(mesh, numbers_of(of_mesh)), i));
  }
  return scene;
}

grf::Scene with_smooth_normals(const SelectedFaces& faces, double crease) {
  return edited_scene(faces,
                      [crease](const grf::Mesh& mesh) { return convert::with_smooth_normals(mesh, crease); });
}

grf::Scene with_flat_faces(const SelectedFaces& faces) {
  return edited_scene(faces, [](const grf::Mesh& mesh) { return convert::with_flat_faces(mesh); });
}

grf::Scene flipped(const SelectedFaces& faces) { return edited_scene(faces, flipped_mesh); }

grf::Scene with_outward_faces(const SelectedFaces& faces) {
  return with_edited_meshes(faces, convert::oriented_outward);
}

FaceSelection inward_faces(const SelectedFaces& faces) {
  FaceSelection found(faces.objects);
  for (const std::uint32_t mesh : faces.selection.meshes()) {
    const std::vector<bool> inward = convert::inward_faces(faces.objects.meshes[mesh].mesh->geometry);
    for (std::uint32_t face = 0; face < inward.size(); ++face) {
      if (inward[face]) found.set({mesh, face});
    }
  }
  return found;
}

grf::Scene with_vertex_colours(const SelectedFaces& faces, std::optional<grf::Colour> colour) {
  const auto edit = [&colour](const grf::Mesh& mesh) {
    grf::MeshDraft edited(mesh);
    edited.colours = same_at_all<grf::Colour>(edited.positions.size(), colour);
    return grf::Mesh(std::move(edited));
  };
  return edited_scene(faces, edit);
}

grf::Scene with_irradiance(const SelectedFaces& faces, std::optional<grf::Colour> irradiance) {
  const auto edit = [&irradiance](const grf::Mesh& mesh) {
    grf::Mesh edited = mesh;
    edited.irradiance = same_at_all<grf::Irradiance>(mesh.geometry->positions.size(), irradiance);
    return edited;
  };
  return edited_scene(faces, edit);
}

grf::Scene with_subdivided_meshes(const SelectedFaces& faces, const convert::Subdivision& subdivision) {
  return with_edited_meshes(
      faces, [&subdivision](const grf::Mesh& mesh) { return convert::subdivided(mesh, subdivision); });
}

double faces_after(const SelectedFaces& faces, const convert::Subdivision& subdivision) {
  double sum = 0;
  for (const std::uint32_t i : at_all_places(faces.scene, faces.objects, faces.selection).meshes()) {
    sum += convert::faces_after(*faces.objects.meshes[i].mesh, subdivision);
  }
  return sum;
}

grf::Scene with_smooth_meshes(const SelectedFaces& faces, int steps) {
  return with_edited_meshes(faces, [steps](const grf::Mesh& mesh) { return convert::smoothed(mesh, steps); });
}

grf::Scene without_faces(const SelectedFaces& faces) {
  grf::Scene scene = faces.scene;
  std::vector<grf::ScenePath> gone;
  const FaceSelection selection = at_all_places(faces.scene, faces.objects, faces.selection);
  for (const std::uint32_t i : selection.meshes()) {
    const FaceSelection::Faces& of_mesh = selection.of_mesh(i);
    const MeshObject& object = faces.objects.meshes[i];
    if (of_mesh.all()) {
      gone.push_back(object.path);
      continue;
    }
    convert::Rebuild rebuild(*object.mesh);
    for (std::size_t face = 0; face < of_mesh.size(); ++face) {
      if (!of_mesh[face]) rebuild.add_face(object.mesh->face(face), (*object.mesh->surface_of_face)[face]);
    }
    grf::Mesh rest = rebuild.take();
    remove_unused_surfaces(rest.surfaces, rest.surface_of_face.edit());
    *grf::find_mesh(scene, object.path) = std::move(rest);
  }
  const std::vector<grf::ScenePath> uses = uses_of(scene, gone);
  gone.insert(gone.end(), uses.begin(), uses.end());
  erase(scene, std::move(gone));
  return scene;
}

CommonVertices common_vertices(const SceneObjects& objects, const FaceSelection& selection) {
  CommonVertices common;
  bool is_first_vertex = true;
  for (const std::uint32_t i : selection.meshes()) {
    const grf::Mesh& mesh = *objects.meshes[i].mesh;
    const auto& colours = mesh.geometry->colours;
    const bool has_values = !colours.empty() || !mesh.irradiance->empty();
    const FaceSelection::Faces& faces = selection.of_mesh(i);
    bool is_first = true;
    for (auto face = faces.find_first(); face != FaceSelection::Faces::npos; face = faces.find_next(face)) {
      // Vertices without attributes are all equal.
      if (!is_first && !has_values && (common.have_normals || mesh.geometry->normals.empty())) break;
      is_first = false;
      for (const std::uint32_t corner : mesh.face(face)) {
        common.have_normals = common.have_normals || mesh.geometry->normals.has(corner);
        common.colour.meet(colours.has(corner) ? std::optional(colours[corner]) : std::nullopt,
                           is_first_vertex);
        const auto* value = mesh.irradiance->has(corner) ? &(*mesh.irradiance)[corner] : nullptr;
        const auto* single = value == nullptr ? nullptr : std::get_if<grf::Colour>(value);
        common.irradiance.meet(single == nullptr ? std::nullopt : std::optional(*single), is_first_vertex);
        if (value != nullptr && single == nullptr) common.irradiance.is_mixed = true;
        is_first_vertex = false;
      }
    }
  }
  return common;
}

}  // namespace editor
