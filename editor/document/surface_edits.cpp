#include "editor/document/surface_edits.h"

#include <algorithm>
#include <iterator>
#include <unordered_set>
#include <utility>

#include "grf/mesh.h"
#include "grf/summary.h"

namespace editor {
namespace {

/// Converts an edit to one of a mesh light, whose only attribute is a radiance, stored as its colour.
SurfaceEdit of_mesh_light(const SurfaceEdit& edit) {
  SurfaceEdit radiance;
  if (!edit.emission.is_any()) return radiance;
  radiance.colour = edit.emission.value() ? AttributeEdit<grf::ColourAttribute>::set(*edit.emission.value())
                                          : AttributeEdit<grf::ColourAttribute>::remove();
  return radiance;
}

/// Converts the surface of a mesh light to that of an emissive mesh.
grf::Surface as_mesh_surface(const FlatSurface& flat_surface) {
  grf::Surface surface;
  surface.emission = flat_surface.colour;
  return surface;
}

/// Counts the faces of each surface of a mesh.
std::vector<std::size_t> uses_of_surfaces(const grf::Mesh& mesh) {
  std::vector<std::size_t> uses(mesh.surfaces.size());
  // Faces of one surface are mostly consecutive: a run is counted at once.
  const std::vector<std::uint32_t>& surfaces = *mesh.surface_of_face;
  for (auto run = surfaces.begin(); run != surfaces.end();) {
    const auto end = std::find_if(run, surfaces.end(), [run](std::uint32_t each) { return each != *run; });
    uses[*run] += static_cast<std::size_t>(end - run);
    run = end;
  }
  return uses;
}

bool are_different(const std::vector<grf::Surface>& surfaces) {
  const auto hash = [](const grf::Surface* surface) { return grf::hash_value(*surface); };
  const auto equal = [](const grf::Surface* a, const grf::Surface* b) { return *a == *b; };
  std::unordered_set<const grf::Surface*, decltype(hash), decltype(equal)> known(surfaces.size());
  return std::ranges::all_of(surfaces,
                             [&known](const grf::Surface& surface) { return known.insert(&surface).second; });
}

/// A mesh in which faces are assigned to other surfaces.
class Reassignment {
 public:
  Reassignment(const grf::Mesh& mesh, const SurfaceEdits& edits)
      : mesh_(mesh), edits_(edits), surfaces_(mesh.surfaces) {}

  grf::Mesh run(const FaceSelection& selection, std::uint32_t number) {
    grf::Mesh result = mesh_;
    if (!edit_whole_surfaces(selection, number)) {
      std::vector<std::uint32_t> surface_of_face = *mesh_.surface_of_face;
      reassign(selection, number, surface_of_face);
      remove_unused_surfaces(surfaces_, surface_of_face);
      if (surface_of_face != *mesh_.surface_of_face) result.surface_of_face = std::move(surface_of_face);
    }
    result.surfaces = std::move(surfaces_);
    return result;
  }

 private:
  /// Edits surfaces in place if all of their faces are selected, so that no face is reassigned. Returns
  /// false, with nothing done, if that is not sufficient: the first surface is the mesh's own, which is kept
  /// for unlisted faces as long as two are used, and no two surfaces may become equal.
  bool edit_whole_surfaces(const FaceSelection& selection, std::uint32_t number) {
    const std::vector<std::size_t> uses = uses_of_surfaces(mesh_);
    std::vector<std::size_t> selected(uses.size());
    selection.for_each_face(number, [&](std::size_t face) { ++selected[(*mesh_.surface_of_face)[face]]; });
    const bool is_own_replaced = uses[0] == 0 && std::ranges::count(uses, 0U) + 1 == std::ssize(uses);
    if (is_own_replaced) return false;
    std::vector<grf::Surface> changed = surfaces_;
    for (std::size_t i = 0; i < uses.size(); ++i) {
      if (selected[i] == 0) continue;
      const bool is_own_beside_others = i == 0 && uses.size() > 1;
      if (selected[i] != uses[i] || is_own_beside_others) return false;
      edits_(mesh_.surfaces[i]).apply(changed[i]);
    }
    if (!are_different(changed)) return false;
    surfaces_ = std::move(changed);
    return true;
  }

  void reassign(const FaceSelection& selection, std::uint32_t number,
                std::vector<std::uint32_t>& surface_of_face) {
    grf::SurfaceIndex index(surfaces_);
    std::vector<std::optional<std::uint32_t>> after(surfaces_.size());
    selection.for_each_face(number, [&](std::size_t face) {
      std::uint32_t& surface = surface_of_face[face];
      auto& known = after[surface];
      if (!known) known = edited(surface, index);
      surface = *known;
    });
  }

  std::uint32_t edited(std::uint32_t surface, grf::SurfaceIndex& index) const {
    grf::Surface changed = mesh_.surfaces[surface];
    edits_(changed).apply(changed);
    return index.index_of(changed);
  }

  const grf::Mesh& mesh_;
  const SurfaceEdits& edits_;
  std::vector<grf::Surface> surfaces_;
};

}  // namespace

void SurfaceEdit::apply(grf::Surface& surface) const {
  colour.apply(surface.colour);
  brdf.apply(surface.brdf);
  pdf.apply(surface.pdf);
  texture.apply(surface.texture);
  emission.apply(surface.emission);
  opacity.apply(surface.opacity);
}

SurfaceEdit edit_to(const grf::Surface& surface) {
  const auto to = []<class Value>(const std::optional<Value>& value) {
    return value ? AttributeEdit<Value>::set(*value) : AttributeEdit<Value>::remove();
  };
  return {to(surface.colour),  to(surface.brdf),     to(surface.pdf),
          to(surface.texture), to(surface.emission), to(surface.opacity)};
}

void remove_unused_surfaces(std::vector<grf::Surface>& surfaces,
                            std::vector<std::uint32_t>& surface_of_face) {
  std::vector<bool> used(surfaces.size());
  for (const std::uint32_t surface : surface_of_face) used[surface] = true;
  const bool keeps_own = std::ranges::count(used, true) != 1;
  std::vector<std::uint32_t> places(used.size(), 0);
  std::vector<grf::Surface> kept;
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (!used[i] && (i > 0 || !keeps_own)) continue;
    places[i] = static_cast<std::uint32_t>(kept.size());
    kept.push_back(std::move(surfaces[i]));
  }
  surfaces = std::move(kept);
  for (std::uint32_t& surface : surface_of_face) surface = places[surface];
}

CommonSurface common_surface(const SceneObjects& objects, const FaceSelection& selection) {
  CommonSurface common;
  bool is_first = true;
  for (const std::uint32_t i : selection.meshes()) {
    const MeshObject& object = objects.meshes[i];
    const std::vector<bool> has = selected_surfaces(objects, selection, i);
    for (std::size_t k = 0; k < has.size(); ++k) {
      if (!has[k]) continue;
      const grf::Surface& surface =
          object.is_light ? as_mesh_surface(object.flat_surfaces[k]) : object.mesh->surfaces[k];
      common.colour.meet(surface.colour, is_first);
      common.brdf.meet(surface.brdf, is_first);
      common.pdf.meet(surface.pdf, is_first);
      common.texture.meet(surface.texture, is_first);
      common.emission.meet(surface.emission, is_first);
      common.opacity.meet(surface.opacity, is_first);
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
    const std::vector<bool> has = selected_surfaces(objects, selection, i);
    for (std::size_t k = 0; k < has.size(); ++k) {
      const MeshBrdf brdf = {i, object.mesh->surfaces[k].brdf};
      if (has[k] && std::find(brdfs.begin() + first, brdfs.end(), brdf) == brdfs.end()) brdfs.push_back(brdf);
    }
  }
  return brdfs;
}

double selected_area(const SceneObjects& objects, const FaceSelection& selection) {
  double area = 0;
  for (const MeshInstance& instance : *objects.instances) {
    const grf::Mesh& mesh = *objects.meshes[instance.mesh].mesh;
    selection.for_each_face(instance.mesh, [&](std::size_t face) {
      area += grf::doubled_area_vector(*mesh.geometry, face, instance.to_world).length() / 2;
    });
  }
  return area;
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
    result.push_back({object.path, reassignment.run(selection, i)});
  }
  return result;
}

}  // namespace editor
