#include "editor/document/surface_edits.h"

#include <algorithm>
#include <utility>

#include "grf/mesh.h"
#include "grf/summary.h"

namespace editor {
namespace {

/// Which of a mesh's surfaces selected faces have.
std::vector<bool> selected_surfaces(const grf::Mesh& mesh, const std::vector<bool>& faces) {
  std::vector<bool> has(mesh.surfaces.size());
  for (std::size_t face = 0; face < faces.size(); ++face) {
    if (faces[face]) has[(*mesh.surface_of_face)[face]] = true;
  }
  return has;
}

template <class Value>
void meet(CommonValue<Value>& common, const std::optional<Value>& value, bool is_first) {
  if (is_first) {
    common.value = value;
  } else if (common.value != value) {
    common.is_mixed = true;
  }
}

/// What an edit gives to the faces of a mesh light, which have a radiance alone, as their colour.
SurfaceEdit of_mesh_light(const SurfaceEdit& edit) {
  SurfaceEdit radiance;
  if (!edit.emission.is_any()) return radiance;
  radiance.colour = edit.emission.value() ? AttributeEdit<grf::ColourAttribute>::set(*edit.emission.value())
                                          : AttributeEdit<grf::ColourAttribute>::remove();
  return radiance;
}

/// What faces of a mesh light have, as though the mesh had it.
grf::Surface seen_as_mesh(const Look& look) {
  grf::Surface surface;
  surface.emission = look.colour;
  return surface;
}

/// A mesh of which some faces get other surfaces.
class Reassignment {
 public:
  Reassignment(const grf::Mesh& mesh, const SurfaceEdits& edits)
      : mesh_(mesh), edits_(edits), surfaces_(mesh.surfaces), surface_of_face_(*mesh.surface_of_face) {}

  grf::Mesh run(const std::vector<bool>& faces) {
    grf::SurfaceIndex index(surfaces_);
    std::vector<std::optional<std::uint32_t>> after(surfaces_.size());
    for (std::size_t face = 0; face < faces.size(); ++face) {
      if (!faces[face]) continue;
      std::uint32_t& surface = surface_of_face_[face];
      auto& known = after[surface];
      if (!known) known = edited(surface, index);
      surface = *known;
    }
    grf::Mesh result = mesh_;
    remove_unused();
    result.surfaces = std::move(surfaces_);
    if (surface_of_face_ != *mesh_.surface_of_face) result.surface_of_face = std::move(surface_of_face_);
    return result;
  }

 private:
  std::uint32_t edited(std::uint32_t surface, grf::SurfaceIndex& index) const {
    grf::Surface changed = mesh_.surfaces[surface];
    edits_(changed).apply(changed);
    return index.index_of(changed);
  }

  // The first surface is what the mesh says before its lists: where all faces have another, that becomes it.
  void remove_unused() {
    std::vector<bool> used(surfaces_.size());
    for (const std::uint32_t surface : surface_of_face_) used[surface] = true;
    std::vector<std::uint32_t> places(used.size(), 0);
    std::vector<grf::Surface> kept;
    const auto uses = std::count(used.begin(), used.end(), true);
    for (std::size_t i = 0; i < used.size(); ++i) {
      const bool is_own = i == 0 && uses != 1;
      if (!used[i] && !is_own) continue;
      places[i] = static_cast<std::uint32_t>(kept.size());
      kept.push_back(std::move(surfaces_[i]));
    }
    surfaces_ = std::move(kept);
    for (std::uint32_t& surface : surface_of_face_) surface = places[surface];
  }

  const grf::Mesh& mesh_;
  const SurfaceEdits& edits_;
  std::vector<grf::Surface> surfaces_;
  std::vector<std::uint32_t> surface_of_face_;
};

}  // namespace

void SurfaceEdit::apply(grf::Surface& surface) const {
  colour.apply(surface.colour);
  brdf.apply(surface.brdf);
  pdf.apply(surface.pdf);
  texture.apply(surface.texture);
  emission.apply(surface.emission);
}

SurfaceEdit edit_to(const grf::Surface& surface) {
  const auto to = []<class Value>(const std::optional<Value>& value) {
    return value ? AttributeEdit<Value>::set(*value) : AttributeEdit<Value>::remove();
  };
  return {to(surface.colour), to(surface.brdf), to(surface.pdf), to(surface.texture), to(surface.emission)};
}

CommonSurface common_surface(const SceneObjects& objects, const FaceSelection& selection) {
  CommonSurface common;
  bool is_first = true;
  for (const std::uint32_t i : selection.meshes()) {
    const MeshObject& object = objects.meshes[i];
    const std::vector<bool> has = selected_surfaces(*object.mesh, selection.of_mesh(i));
    for (std::size_t k = 0; k < has.size(); ++k) {
      if (!has[k]) continue;
      const grf::Surface& surface =
          object.is_light ? seen_as_mesh(object.looks[k]) : object.mesh->surfaces[k];
      meet(common.colour, surface.colour, is_first);
      meet(common.brdf, surface.brdf, is_first);
      meet(common.pdf, surface.pdf, is_first);
      meet(common.texture, surface.texture, is_first);
      meet(common.emission, surface.emission, is_first);
      is_first = false;
    }
  }
  return common;
}

std::vector<MeshBrdf> selected_brdfs(const SceneObjects& objects, const FaceSelection& selection) {
  std::vector<MeshBrdf> brdfs;
  for (const std::uint32_t i : selection.meshes()) {
    const MeshObject& object = objects.meshes[i];
    if (object.is_light) continue;
    const auto first = static_cast<std::ptrdiff_t>(brdfs.size());
    const std::vector<bool> has = selected_surfaces(*object.mesh, selection.of_mesh(i));
    for (std::size_t k = 0; k < has.size(); ++k) {
      const MeshBrdf brdf = {i, object.mesh->surfaces[k].brdf};
      if (has[k] && std::find(brdfs.begin() + first, brdfs.end(), brdf) == brdfs.end()) brdfs.push_back(brdf);
    }
  }
  return brdfs;
}

double selected_area(const SceneObjects& objects, const FaceSelection& selection) {
  double area = 0;
  for (const MeshInstance& instance : objects.instances) {
    const std::vector<bool>& faces = selection.of_mesh(instance.mesh);
    const grf::Mesh& mesh = *objects.meshes[instance.mesh].mesh;
    for (std::size_t face = 0; face < faces.size(); ++face) {
      if (faces[face]) area += grf::doubled_area_vector(*mesh.geometry, face, instance.to_world).length() / 2;
    }
  }
  return area;
}

std::vector<PlacedMesh> edited(const SceneObjects& objects, const FaceSelection& selection,
                               const SurfaceEdit& edit) {
  return edited(objects, selection, [&edit](const grf::Surface&) { return edit; });
}

std::vector<PlacedMesh> edited(const SceneObjects& objects, const FaceSelection& selection,
                               const SurfaceEdits& edits) {
  const SurfaceEdits of_light = [&edits](const grf::Surface& surface) {
    return of_mesh_light(edits(surface));
  };
  std::vector<PlacedMesh> result;
  for (const std::uint32_t i : selection.meshes()) {
    const MeshObject& object = objects.meshes[i];
    Reassignment reassignment(*object.mesh, object.is_light ? of_light : edits);
    result.push_back({object.path, reassignment.run(selection.of_mesh(i))});
  }
  return result;
}

}  // namespace editor
