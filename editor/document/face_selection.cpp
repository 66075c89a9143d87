#include "editor/document/face_selection.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "grf/summary.h"
#include "grf/topology.h"

namespace editor {
namespace {

/// Which faces of a mesh share an edge with which.
class Neighbours {
 public:
  explicit Neighbours(const grf::Mesh& mesh) : offsets_(mesh.face_count() + 1) {
    const auto edges = grf::edges_of_faces(mesh, grf::first_at_place(mesh));
    grf::for_each_edge(edges, [this](std::span<const grf::FaceEdge> of_faces) {
      for (const grf::FaceEdge& edge : of_faces) offsets_[edge.face + 1] += of_faces.size() - 1;
    });
    for (std::size_t i = 1; i < offsets_.size(); ++i) offsets_[i] += offsets_[i - 1];
    faces_.resize(offsets_.back());
    std::vector<std::size_t> next(offsets_.begin(), offsets_.end() - 1);
    grf::for_each_edge(edges, [&](std::span<const grf::FaceEdge> of_faces) {
      for (const grf::FaceEdge& edge : of_faces) {
        for (const grf::FaceEdge& other : of_faces) {
          if (&other != &edge) faces_[next[edge.face]++] = other.face;
        }
      }
    });
  }

  std::span<const std::uint32_t> of(std::uint32_t face) const {
    return std::span(faces_).subspan(offsets_[face], offsets_[face + 1] - offsets_[face]);
  }

 private:
  std::vector<std::size_t> offsets_;
  std::vector<std::uint32_t> faces_;
};

/// Spreads from the selected faces to their neighbours, and on from there, as long as `admits` the step.
template <class Admits>
void spread(std::uint32_t mesh, const grf::Mesh& geometry, FaceSelection& selection, const Admits& admits) {
  const Neighbours neighbours(geometry);
  std::vector<std::uint32_t> front;
  for (std::uint32_t face = 0; face < geometry.face_count(); ++face) {
    if (selection.has({mesh, face})) front.push_back(face);
  }
  while (!front.empty()) {
    const std::uint32_t face = front.back();
    front.pop_back();
    for (const std::uint32_t other : neighbours.of(face)) {
      if (selection.has({mesh, other}) || !admits(face, other)) continue;
      selection.set({mesh, other});
      front.push_back(other);
    }
  }
}

/// What faces have, and what its names mean there: a name can mean other things in another scope.
struct SurfaceAndLook {
  const grf::Surface* surface;
  const Look* look;
};

bool have_same_look(const Look& a, const Look& b) {
  return a.colour == b.colour && a.brdf == b.brdf && a.terms == b.terms && a.texture == b.texture;
}

bool are_alike(const SurfaceAndLook& first, const SurfaceAndLook& second, Likeness likeness) {
  const grf::Surface& a = *first.surface;
  const grf::Surface& b = *second.surface;
  switch (likeness) {
    case Likeness::Brdf:
      return a.brdf == b.brdf && first.look->brdf == second.look->brdf &&
             first.look->terms == second.look->terms;
    case Likeness::Pdf:
      return a.pdf == b.pdf;
    case Likeness::Colour:
      return a.colour == b.colour && first.look->colour == second.look->colour;
    case Likeness::Texture:
      return a.texture == b.texture && first.look->texture == second.look->texture;
    case Likeness::Emission:
      return a.emission == b.emission;
    case Likeness::All:
      return a == b && have_same_look(*first.look, *second.look);
  }
  return false;
}

}  // namespace

FaceSelection::FaceSelection(const SceneObjects& objects) {
  for (const MeshObject& mesh : objects.meshes) faces_.emplace_back(mesh.mesh->face_count());
}

void FaceSelection::set(FaceId face, bool is_selected) {
  auto entry = faces_[face.mesh][face.face];
  if (entry == is_selected) return;
  entry = is_selected;
  if (is_selected) {
    ++count_;
  } else {
    --count_;
  }
}

void FaceSelection::set_mesh(std::uint32_t mesh, bool is_selected) {
  std::vector<bool>& faces = faces_[mesh];
  count_ -= static_cast<std::size_t>(std::count(faces.begin(), faces.end(), true));
  faces.assign(faces.size(), is_selected);
  if (is_selected) count_ += faces.size();
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
    const std::vector<bool>& faces = faces_[i];
    if (std::find(faces.begin(), faces.end(), true) != faces.end()) meshes.push_back(i);
  }
  return meshes;
}

void FaceSelection::invert() {
  count_ = 0;
  for (std::vector<bool>& faces : faces_) {
    faces.flip();
    count_ += static_cast<std::size_t>(std::count(faces.begin(), faces.end(), true));
  }
}

void FaceSelection::add(const FaceSelection& other) {
  for (std::uint32_t i = 0; i < faces_.size(); ++i) {
    for (std::uint32_t face = 0; face < faces_[i].size(); ++face) {
      if (other.has({i, face})) set({i, face});
    }
  }
}

void FaceSelection::remove(const FaceSelection& other) {
  for (std::uint32_t i = 0; i < faces_.size(); ++i) {
    for (std::uint32_t face = 0; face < faces_[i].size(); ++face) {
      if (other.has({i, face})) set({i, face}, false);
    }
  }
}

FaceSelection grown(const FaceSelection& selection, const SceneObjects& objects) {
  FaceSelection result = selection;
  for (const std::uint32_t i : selection.meshes()) {
    const grf::Mesh& mesh = *objects.meshes[i].mesh;
    const auto edges = grf::edges_of_faces(mesh, grf::first_at_place(mesh));
    grf::for_each_edge(edges, [&](std::span<const grf::FaceEdge> of_faces) {
      const bool is_selected = std::any_of(of_faces.begin(), of_faces.end(), [&](const grf::FaceEdge& edge) {
        return selection.has({i, edge.face});
      });
      if (!is_selected) return;
      for (const grf::FaceEdge& edge : of_faces) result.set({i, edge.face});
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
    spread(i, mesh, result, [](std::uint32_t, std::uint32_t) { return true; });
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
      normals.push_back(grf::doubled_area_vector(mesh, face, {}).normalized());
    }
    // Each face is compared with the selected one that it was reached from, so that a bend of many small
    // steps ends.
    std::vector<std::uint32_t> seeds(mesh.face_count());
    for (std::uint32_t face = 0; face < seeds.size(); ++face) seeds[face] = face;
    spread(i, mesh, result, [&](std::uint32_t from, std::uint32_t to) {
      if (normals[seeds[from]].dot(normals[to]) < least) return false;
      seeds[to] = seeds[from];
      return true;
    });
  }
  return result;
}

FaceSelection alike(const FaceSelection& selection, const SceneObjects& objects, Likeness likeness) {
  std::vector<SurfaceAndLook> wanted;
  const auto is_wanted = [&](const SurfaceAndLook& one) {
    return std::any_of(wanted.begin(), wanted.end(),
                       [&](const SurfaceAndLook& other) { return are_alike(one, other, likeness); });
  };
  for (const std::uint32_t i : selection.meshes()) {
    const grf::Mesh& mesh = *objects.meshes[i].mesh;
    const std::vector<Look>& looks = objects.meshes[i].looks;
    std::vector<bool> is_used(mesh.surfaces.size());
    for (std::uint32_t face = 0; face < mesh.face_count(); ++face) {
      if (selection.has({i, face})) is_used[mesh.surface_of_face[face]] = true;
    }
    for (std::size_t k = 0; k < is_used.size(); ++k) {
      const SurfaceAndLook one = {&mesh.surfaces[k], &looks[k]};
      if (is_used[k] && !is_wanted(one)) wanted.push_back(one);
    }
  }
  FaceSelection result(objects);
  for (std::uint32_t i = 0; i < objects.meshes.size(); ++i) {
    const grf::Mesh& mesh = *objects.meshes[i].mesh;
    std::vector<bool> takes;
    for (std::size_t k = 0; k < mesh.surfaces.size(); ++k) {
      takes.push_back(is_wanted({&mesh.surfaces[k], &objects.meshes[i].looks[k]}));
    }
    for (std::uint32_t face = 0; face < mesh.face_count(); ++face) {
      if (takes[mesh.surface_of_face[face]]) result.set({i, face});
    }
  }
  return result;
}

}  // namespace editor
