#include "editor/document/face_selection.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_set>

#include "grf/summary.h"
#include "grf/topology.h"

namespace editor {
namespace {

/// Grows a selection over the edges of a mesh.
class Spread {
 public:
  Spread(std::uint32_t mesh, const grf::Mesh& geometry, FaceSelection& selection)
      : mesh_(mesh),
        geometry_(&geometry),
        selection_(&selection),
        edges_(*geometry.geometry, grf::first_at_position(*geometry.geometry)),
        unselected_(edges_.edge_count()) {
    for (std::uint32_t edge = 0; edge < edges_.edge_count(); ++edge) {
      for (const grf::HalfEdge& of_face : edges_.faces_at(edge)) {
        if (!selection.has({mesh, of_face.face})) ++unselected_[edge];
      }
    }
    selection.for_each_face(mesh,
                            [this](std::size_t face) { front_.push_back(static_cast<std::uint32_t>(face)); });
  }

  /// Breadth-first search from the selected faces over shared edges, as long as `admits(from, to)` is true.
  template <class Admits>
  void run(const Admits& admits) {
    while (!front_.empty()) {
      const std::uint32_t from = front_.back();
      front_.pop_back();
      for_each_edge_of(from, [&](std::uint32_t edge) {
        if (unselected_[edge] == 0) return;
        for (const grf::HalfEdge& of_face : edges_.faces_at(edge)) {
          const std::uint32_t to = of_face.face;
          if (!selection_->has({mesh_, to}) && admits(from, to)) select(to);
        }
      });
    }
  }

 private:
  template <class Action>
  void for_each_edge_of(std::uint32_t face, const Action& action) const {
    for (std::uint32_t corner = geometry_->geometry->face_offsets[face];
         corner < geometry_->geometry->face_offsets[face + 1]; ++corner) {
      const std::uint32_t edge = edges_.at_corner(corner);
      if (edge != grf::SharedEdges::InvalidIndex) action(edge);
    }
  }

  void select(std::uint32_t face) {
    selection_->set({mesh_, face});
    for_each_edge_of(face, [this](std::uint32_t edge) { --unselected_[edge]; });
    front_.push_back(face);
  }

  std::uint32_t mesh_;
  const grf::Mesh* geometry_;
  FaceSelection* selection_;
  grf::SharedEdges edges_;
  std::vector<std::uint32_t> unselected_;  ///< number of unselected faces per edge
  std::vector<std::uint32_t> front_;       ///< selected faces that are still to be expanded
};

/// The compared attributes of a face: its surface as written, and the resolved values, since a name can
/// resolve differently in another scope.
struct SimilarityKey {
  grf::Surface written;
  grf::Surface meant;
  std::vector<FlatTerm> terms;

  bool operator==(const SimilarityKey&) const = default;
};

std::size_t hash_of(const SimilarityKey& key) {
  std::size_t hash = grf::hash_value(key.written) + 31 * grf::hash_value(key.meant);
  for (const FlatTerm& term : key.terms) {
    grf::Surface of_term;
    of_term.brdf = term.brdf;
    hash = 31 * hash + grf::hash_value(of_term);
  }
  return hash;
}

SimilarityKey key_of(const grf::Surface& surface, const FlatSurface& flat_surface, SimilarBy by) {
  const bool all = by == SimilarBy::All;
  SimilarityKey key;
  if (all || by == SimilarBy::Brdf) {
    key.written.brdf = surface.brdf;
    key.meant.brdf = flat_surface.brdf;
    key.terms = flat_surface.terms;
  }
  if (all || by == SimilarBy::Pdf) key.written.pdf = surface.pdf;
  if (all || by == SimilarBy::Colour) {
    key.written.colour = surface.colour;
    key.meant.colour = flat_surface.colour;
  }
  if (all || by == SimilarBy::Texture) {
    key.written.texture = surface.texture;
    key.meant.texture = grf::Reference{flat_surface.texture, {}};
  }
  if (all || by == SimilarBy::Emission) key.written.emission = surface.emission;
  return key;
}

}  // namespace

FaceSelection::FaceSelection(const SceneObjects& objects) : counts_(objects.meshes.size()) {
  faces_.reserve(objects.meshes.size());
  for (const MeshObject& mesh : objects.meshes) faces_.emplace_back(mesh.mesh->face_count());
}

void FaceSelection::count_faces(std::uint32_t mesh) {
  count_ -= counts_[mesh];
  counts_[mesh] = faces_[mesh].count();
  count_ += counts_[mesh];
}

void FaceSelection::set(FaceId face, bool is_selected) {
  if (has(face) == is_selected) return;
  faces_[face.mesh][face.face] = is_selected;
  counts_[face.mesh] += is_selected ? 1 : -1;
  count_ += is_selected ? 1 : -1;
}

void FaceSelection::set_mesh(std::uint32_t mesh, bool is_selected) {
  if (is_selected) {
    faces_[mesh].set();
  } else {
    faces_[mesh].reset();
  }
  count_faces(mesh);
}

void FaceSelection::set_faces(std::uint32_t mesh, const Faces& faces) {
  faces_[mesh] = faces;
  count_faces(mesh);
}

void FaceSelection::clear() {
  for (std::uint32_t i = 0; i < faces_.size(); ++i) set_mesh(i, false);
}

void FaceSelection::select_all() {
  for (std::uint32_t i = 0; i < faces_.size(); ++i) set_mesh(i, true);
}

std::vector<std::uint32_t> FaceSelection::meshes() const {
  std::vector<std::uint32_t> meshes;
  for (std::uint32_t i = 0; i < faces_.size(); ++i) {
    if (counts_[i] > 0) meshes.push_back(i);
  }
  return meshes;
}

void FaceSelection::invert() {
  for (std::uint32_t i = 0; i < faces_.size(); ++i) {
    faces_[i].flip();
    count_faces(i);
  }
}

void FaceSelection::add(const FaceSelection& other) {
  for (const std::uint32_t i : other.meshes()) {
    faces_[i] |= other.faces_[i];
    count_faces(i);
  }
}

void FaceSelection::remove(const FaceSelection& other) {
  for (const std::uint32_t i : other.meshes()) {
    faces_[i] -= other.faces_[i];
    count_faces(i);
  }
}

bool FaceSelection::fits(const SceneObjects& objects) const {
  if (objects.meshes.size() != faces_.size()) return false;
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    if (objects.meshes[i].mesh->face_count() != faces_[i].size()) return false;
  }
  return true;
}

FaceCorrespondence::FaceCorrespondence(const SceneObjects& before, const SceneObjects& now)
    : now_(&now), before_of_(now.meshes.size()) {
  std::multimap<const grf::Geometry*, std::uint32_t> known;
  std::map<grf::ScenePath, std::uint32_t> places;
  for (std::uint32_t i = 0; i < before.meshes.size(); ++i) {
    known.emplace(&*before.meshes[i].mesh->geometry, i);
    places.emplace(before.meshes[i].path, i);
  }
  for (std::uint32_t i = 0; i < now.meshes.size(); ++i) {
    const MeshObject& object = now.meshes[i];
    std::optional<std::uint32_t> match;
    if (const auto same = known.find(&*object.mesh->geometry); same != known.end()) {
      match = same->second;
      known.erase(same);
    } else if (const auto place = places.find(object.path); place != places.end()) {
      match = place->second;
    }
    if (match && before.meshes[*match].mesh->face_count() == object.mesh->face_count()) before_of_[i] = match;
  }
}

FaceSelection FaceCorrespondence::carried_over(const FaceSelection& selection) const {
  FaceSelection carried(*now_);
  for (std::uint32_t i = 0; i < before_of_.size(); ++i) {
    const auto before = before_of_[i];
    if (before && *before < selection.mesh_count()) carried.set_faces(i, selection.of_mesh(*before));
  }
  return carried;
}

grf::Box3d bounds_of(const SceneObjects& objects, const FaceSelection& selection) {
  grf::Box3d box;
  for (const MeshInstance& instance : *objects.instances) {
    const grf::Mesh& mesh = *objects.meshes[instance.mesh].mesh;
    selection.for_each_face(instance.mesh, [&](std::size_t face) {
      for (const std::uint32_t corner : mesh.face(face)) {
        box.extendBy(grf::Vec3d(mesh.geometry->positions[corner]) * instance.to_world);
      }
    });
  }
  return box;
}

std::vector<bool> selected_surfaces(const SceneObjects& objects, const FaceSelection& selection,
                                    std::uint32_t mesh) {
  const grf::Mesh& of_selection = *objects.meshes[mesh].mesh;
  std::vector<bool> has(of_selection.surfaces.size());
  selection.for_each_face(mesh, [&](std::size_t face) { has[(*of_selection.surface_of_face)[face]] = true; });
  return has;
}

FaceSelection grown(const FaceSelection& selection, const SceneObjects& objects) {
  FaceSelection result = selection;
  for (const std::uint32_t i : selection.meshes()) {
    const grf::Mesh& mesh = *objects.meshes[i].mesh;
    const auto edges = grf::half_edges_of(*mesh.geometry, grf::first_at_position(*mesh.geometry));
    grf::for_each_edge(edges, [&](std::span<const grf::HalfEdge> of_faces) {
      const bool is_selected = std::ranges::any_of(of_faces, [&](const grf::HalfEdge& edge) {
        return selection.has({i, edge.face});
      });
      if (!is_selected) return;
      for (const grf::HalfEdge& edge : of_faces) result.set({i, edge.face});
    });
  }
  return result;
}

FaceSelection shrunk(const FaceSelection& selection, const SceneObjects& objects) {
  FaceSelection outside = selection;
  outside.invert();
  FaceSelection result = selection;
  result.remove(grown(outside, objects));
  return result;
}

FaceSelection connected(const FaceSelection& selection, const SceneObjects& objects) {
  FaceSelection result = selection;
  for (const std::uint32_t i : selection.meshes()) {
    const grf::Mesh& mesh = *objects.meshes[i].mesh;
    Spread(i, mesh, result).run([](std::uint32_t, std::uint32_t) { return true; });
  }
  return result;
}

FaceSelection coplanar(const FaceSelection& selection, const SceneObjects& objects, double radians) {
  FaceSelection result = selection;
  const double least = std::cos(radians);
  for (const std::uint32_t i : selection.meshes()) {
    const grf::Mesh& mesh = *objects.meshes[i].mesh;
    std::vector<grf::Vec3d> normals;
    for (std::size_t face = 0; face < mesh.face_count(); ++face) {
      normals.push_back(grf::doubled_area_vector(*mesh.geometry, face, {}).normalized());
    }
    // Each face is compared with the selected face from which it was reached, so that gentle bends do not
    // accumulate.
    std::vector<std::uint32_t> seeds(mesh.face_count());
    for (std::uint32_t face = 0; face < seeds.size(); ++face) seeds[face] = face;
    Spread(i, mesh, result).run([&](std::uint32_t from, std::uint32_t to) {
      if (normals[seeds[from]].dot(normals[to]) < least) return false;
      seeds[to] = seeds[from];
      return true;
    });
  }
  return result;
}

FaceSelection select_similar(const FaceSelection& selection, const SceneObjects& objects, SimilarBy by) {
  std::unordered_set<SimilarityKey, decltype(&hash_of)> wanted(0, &hash_of);
  for (const std::uint32_t i : selection.meshes()) {
    const grf::Mesh& mesh = *objects.meshes[i].mesh;
    const std::vector<bool> is_used = selected_surfaces(objects, selection, i);
    for (std::size_t k = 0; k < is_used.size(); ++k) {
      if (is_used[k]) wanted.insert(key_of(mesh.surfaces[k], objects.meshes[i].flat_surfaces[k], by));
    }
  }
  FaceSelection result(objects);
  for (std::uint32_t i = 0; i < objects.meshes.size(); ++i) {
    const grf::Mesh& mesh = *objects.meshes[i].mesh;
    std::vector<bool> takes;
    for (std::size_t k = 0; k < mesh.surfaces.size(); ++k) {
      takes.push_back(wanted.contains(key_of(mesh.surfaces[k], objects.meshes[i].flat_surfaces[k], by)));
    }
    for (std::uint32_t face = 0; face < mesh.face_count(); ++face) {
      if (takes[(*mesh.surface_of_face)[face]]) result.set({i, face});
    }
  }
  return result;
}

}  // namespace editor
