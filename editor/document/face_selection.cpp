#include "editor/document/face_selection.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "grf/topology.h"

namespace editor {
namespace {

template <class Action>
void for_each_edge_of(const grf::SharedGeometry& geometry, std::size_t face, const Action& action) {
  const grf::SharedEdges& edges = geometry.edges();
  for (std::uint32_t corner = geometry->face_offsets[face]; corner < geometry->face_offsets[face + 1];
       ++corner) {
    const std::uint32_t edge = edges.at_corner(corner);
    if (edge != grf::SharedEdges::InvalidIndex) action(edge);
  }
}

/// Calls a function with the half-edges of each edge between selected and unselected faces of a mesh.
template <class Action>
void for_each_border_edge(const FaceSelection& selection, const SceneObjects& objects, std::uint32_t mesh,
                          const Action& action) {
  const grf::SharedGeometry& geometry = objects.meshes[mesh].mesh->geometry;
  // Each edge is visited once, as any number of faces can share it.
  std::vector<bool> is_visited(geometry.edges().edge_count());
  selection.for_each_face(mesh, [&](std::size_t face) {
    for_each_edge_of(geometry, face, [&](std::uint32_t edge) {
      if (is_visited[edge]) return;
      is_visited[edge] = true;
      const auto of_faces = geometry.edges().faces_at(edge);
      const bool is_border = std::ranges::any_of(of_faces, [&](const grf::HalfEdge& of_face) {
        return !selection.has({mesh, of_face.face});
      });
      if (is_border) action(of_faces);
    });
  });
}

/// Grows a selection over the edges of a mesh.
class Spread {
 public:
  Spread(std::uint32_t mesh, const SceneObjects& objects, FaceSelection& selection)
      : mesh_(mesh),
        geometry_(&objects.meshes[mesh].mesh->geometry),
        edges_(&geometry_->edges()),
        selection_(&selection) {
    unselected_.reserve(edges_->edge_count());
    for (std::uint32_t edge = 0; edge < edges_->edge_count(); ++edge)
      unselected_.push_back(static_cast<std::uint32_t>(edges_->faces_at(edge).size()));
    selection.for_each_face(mesh,
                            [this](std::size_t face) { expand_from(static_cast<std::uint32_t>(face)); });
  }

  /// Breadth-first search from the selected faces over shared edges, as long as `admits(from, to)` is true.
  template <class Admits>
  void run(const Admits& admits) {
    while (!front_.empty()) {
      const std::uint32_t from = front_.back();
      front_.pop_back();
      for_each_edge_of(*geometry_, from, [&](std::uint32_t edge) {
        if (unselected_[edge] == 0) return;
        for (const grf::HalfEdge& of_face : edges_->faces_at(edge)) {
          const std::uint32_t to = of_face.face;
          if (selection_->has({mesh_, to}) || !admits(from, to)) continue;
          selection_->set({mesh_, to});
          expand_from(to);
        }
      });
    }
  }

 private:
  void expand_from(std::uint32_t face) {
    for_each_edge_of(*geometry_, face, [this](std::uint32_t edge) { --unselected_[edge]; });
    front_.push_back(face);
  }

  std::uint32_t mesh_;
  const grf::SharedGeometry* geometry_;
  const grf::SharedEdges* edges_;
  FaceSelection* selection_;
  std::vector<std::uint32_t> unselected_;  ///< number of unselected faces per edge
  std::vector<std::uint32_t> front_;       ///< selected faces that are still to be expanded
};

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

void FaceSelection::intersect(const FaceSelection& other) {
  for (const std::uint32_t i : meshes()) {
    faces_[i] &= other.faces_[i];
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
    : before_(&before), now_(&now), before_of_(now.meshes.size()) {
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

std::vector<std::uint32_t> FaceCorrespondence::removed() const {
  std::vector<bool> is_there(before_->meshes.size());
  for (const auto before : before_of_) {
    if (before) is_there[*before] = true;
  }
  std::vector<std::uint32_t> removed;
  for (std::uint32_t i = 0; i < is_there.size(); ++i) {
    if (!is_there[i]) removed.push_back(i);
  }
  return removed;
}

std::vector<std::uint32_t> FaceCorrespondence::added() const {
  std::vector<std::uint32_t> added;
  for (std::uint32_t i = 0; i < before_of_.size(); ++i) {
    if (!before_of_[i]) added.push_back(i);
  }
  return added;
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

void select_surfaces(const grf::Mesh& mesh, std::uint32_t index, const std::vector<bool>& surfaces,
                     FaceSelection& selection) {
  for (std::uint32_t face = 0; face < mesh.face_count(); ++face) {
    if (surfaces[(*mesh.surface_of_face)[face]]) selection.set({index, face});
  }
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
    for_each_border_edge(selection, objects, i, [&](std::span<const grf::HalfEdge> of_faces) {
      for (const grf::HalfEdge& edge : of_faces) result.set({i, edge.face});
    });
  }
  return result;
}

FaceSelection shrunk(const FaceSelection& selection, const SceneObjects& objects) {
  FaceSelection result = selection;
  for (const std::uint32_t i : selection.meshes()) {
    for_each_border_edge(selection, objects, i, [&](std::span<const grf::HalfEdge> of_faces) {
      for (const grf::HalfEdge& edge : of_faces) result.set({i, edge.face}, false);
    });
  }
  return result;
}

FaceSelection connected(const FaceSelection& selection, const SceneObjects& objects) {
  FaceSelection result = selection;
  for (const std::uint32_t i : selection.meshes())
    Spread(i, objects, result).run([](std::uint32_t, std::uint32_t) { return true; });
  return result;
}

FaceSelection coplanar(const FaceSelection& selection, const SceneObjects& objects, double radians) {
  FaceSelection result = selection;
  const double least = std::cos(radians);
  for (const std::uint32_t i : selection.meshes()) {
    const grf::Mesh& mesh = *objects.meshes[i].mesh;
    const std::vector<grf::Vec3f>& areas = mesh.geometry.area_vectors();
    const auto normal = [&](std::uint32_t face) { return grf::Vec3d(areas[face]).normalized(); };
    // Each face is compared with the selected face from which it was reached, so that gentle bends do not
    // accumulate.
    std::vector<std::uint32_t> seeds(mesh.face_count());
    for (std::uint32_t face = 0; face < seeds.size(); ++face) seeds[face] = face;
    Spread(i, objects, result).run([&](std::uint32_t from, std::uint32_t to) {
      if (normal(seeds[from]).dot(normal(to)) < least) return false;
      seeds[to] = seeds[from];
      return true;
    });
  }
  return result;
}

}  // namespace editor
