#include "editor/document/surface_edits.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "grf/mesh.h"
#include "grf/summary.h"

namespace editor {
namespace {

/// Which of a mesh's surfaces selected faces have.
std::vector<bool> selected_surfaces(const grf::Mesh& mesh, const std::vector<bool>& faces) {
  std::vector<bool> has(mesh.surfaces.size());
  for (std::size_t face = 0; face < faces.size(); ++face) {
    if (faces[face]) has[mesh.surface_of_face[face]] = true;
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

/// The surfaces of a mesh while some faces get others.
class Reassignment {
 public:
  Reassignment(const grf::Mesh& mesh, const SurfaceEdits& edits) : mesh_(mesh), edits_(edits) {
    holder_.surfaces = mesh.surfaces;
    after_.assign(mesh.surfaces.size(), None);
  }

  MeshSurfaces run(const std::vector<bool>& faces, const grf::ScenePath& path) {
    grf::SurfaceIndex index(holder_.surfaces);
    holder_.surface_of_face = mesh_.surface_of_face;
    for (std::size_t face = 0; face < faces.size(); ++face) {
      if (faces[face]) holder_.surface_of_face[face] = edited(mesh_.surface_of_face[face], index);
    }
    remove_unused();
    return surfaces_of(holder_, path);
  }

 private:
  static constexpr std::uint32_t None = std::numeric_limits<std::uint32_t>::max();

  std::uint32_t edited(std::uint32_t surface, grf::SurfaceIndex& index) {
    std::uint32_t& after = after_[surface];
    if (after == None) {
      grf::Surface changed = mesh_.surfaces[surface];
      edits_(changed).apply(changed);
      after = index.index_of(changed);
    }
    return after;
  }

  // The first surface is what the mesh says before its lists: where all faces have another, that becomes it.
  void remove_unused() {
    const std::vector<bool> used = grf::used_surfaces(holder_);
    std::vector<std::uint32_t> places(used.size(), 0);
    std::vector<grf::Surface> kept;
    const auto uses = std::count(used.begin(), used.end(), true);
    for (std::size_t i = 0; i < used.size(); ++i) {
      const bool is_own = i == 0 && uses != 1;
      if (!used[i] && !is_own) continue;
      places[i] = static_cast<std::uint32_t>(kept.size());
      kept.push_back(holder_.surfaces[i]);
    }
    holder_.surfaces = std::move(kept);
    for (std::uint32_t& surface : holder_.surface_of_face) surface = places[surface];
  }

  const grf::Mesh& mesh_;
  const SurfaceEdits& edits_;
  grf::Mesh holder_;
  std::vector<std::uint32_t> after_;
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

MeshSurfaces surfaces_of(const grf::Mesh& mesh, grf::ScenePath path) {
  MeshSurfaces result = {std::move(path), mesh.surfaces, {}};
  for (const std::uint32_t surface : mesh.surface_of_face) {
    if (result.runs.empty() || result.runs.back().surface != surface) result.runs.push_back({surface, 0});
    ++result.runs.back().faces;
  }
  return result;
}

void put(const MeshSurfaces& surfaces, grf::Mesh& mesh) {
  mesh.surfaces = surfaces.surfaces;
  auto face = mesh.surface_of_face.begin();
  for (const MeshSurfaces::Run& run : surfaces.runs) face = std::fill_n(face, run.faces, run.surface);
}

std::vector<MeshSurfaces> edited(const SceneObjects& objects, const FaceSelection& selection,
                                 const SurfaceEdit& edit) {
  return edited(objects, selection, [&edit](const grf::Surface&) { return edit; });
}

std::vector<MeshSurfaces> edited(const SceneObjects& objects, const FaceSelection& selection,
                                 const SurfaceEdits& edits) {
  const SurfaceEdits of_light = [&edits](const grf::Surface& surface) {
    return of_mesh_light(edits(surface));
  };
  std::vector<MeshSurfaces> result;
  for (const std::uint32_t i : selection.meshes()) {
    const MeshObject& object = objects.meshes[i];
    Reassignment reassignment(*object.mesh, object.is_light ? of_light : edits);
    result.push_back(reassignment.run(selection.of_mesh(i), object.path));
  }
  return result;
}

}  // namespace editor
