// A face selection is a set of faces per mesh, with operations that extend or reduce it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <boost/dynamic_bitset.hpp>

#include "editor/document/scene_objects.h"

namespace editor {

/// A face: the index of its mesh, and its index in the mesh.
struct FaceId {
  std::uint32_t mesh = 0;
  std::uint32_t face = 0;

  bool operator==(const FaceId&) const = default;
};

/// A set of faces of a scene's meshes. A mesh with several instances is selected in all.
class FaceSelection {
 public:
  /// One bit per face of a mesh: whether it is selected.
  using Faces = boost::dynamic_bitset<>;

  FaceSelection() = default;
  /// Constructs an empty selection.
  explicit FaceSelection(const SceneObjects& objects);

  /// Whether these objects have as many meshes, and each as many faces.
  bool fits(const SceneObjects& objects) const;
  std::size_t count() const { return count_; }
  bool empty() const { return count_ == 0; }
  bool has(FaceId face) const { return faces_[face.mesh][face.face]; }
  std::size_t mesh_count() const { return faces_.size(); }
  const Faces& of_mesh(std::uint32_t mesh) const { return faces_[mesh]; }
  /// The number of selected faces of a mesh.
  std::size_t count(std::uint32_t mesh) const { return counts_[mesh]; }
  /// Calls an action for each selected face of a mesh, in time proportional to their number.
  template <class Action>
  void for_each_face(std::uint32_t mesh, const Action& action) const {
    const Faces& faces = faces_[mesh];
    if (counts_[mesh] == 0) return;
    for (auto face = faces.find_first(); face != Faces::npos; face = faces.find_next(face)) action(face);
  }
  /// The meshes with at least one selected face.
  std::vector<std::uint32_t> meshes() const;

  void set(FaceId face, bool is_selected = true);
  void set_mesh(std::uint32_t mesh, bool is_selected = true);
  /// Sets the selected faces of a mesh; one bit per face.
  void set_faces(std::uint32_t mesh, const Faces& faces);
  void clear();
  void select_all();
  void invert();
  /// Adds or removes the faces of another selection of the same objects, or keeps only those.
  void add(const FaceSelection& other);
  void remove(const FaceSelection& other);
  void intersect(const FaceSelection& other);

  bool operator==(const FaceSelection&) const = default;

 private:
  void count_faces(std::uint32_t mesh);

  std::vector<Faces> faces_;
  std::vector<std::size_t> counts_;  ///< per mesh
  std::size_t count_ = 0;
};

/// The correspondence of meshes before and after an edit. Meshes correspond if they have the same geometry,
/// else if they have the same path and number of faces.
class FaceCorrespondence {
 public:
  /// Both objects must exist as long as this one.
  FaceCorrespondence(const SceneObjects& before, const SceneObjects& now);

  /// Returns the same faces after the edit. Faces of meshes that are new are not selected.
  FaceSelection carried_over(const FaceSelection& selection) const;
  /// The meshes before the edit that are not there any more, by their index.
  std::vector<std::uint32_t> removed() const;
  /// The meshes that were not there before the edit, by their index.
  std::vector<std::uint32_t> added() const;

 private:
  const SceneObjects* before_;
  const SceneObjects* now_;
  std::vector<std::optional<std::uint32_t>> before_of_;  ///< index of the mesh before, per mesh now
};

/// The bounds of the selected faces in world space, in all instances; empty if there are none.
grf::Box3d bounds_of(const SceneObjects& objects, const FaceSelection& selection);

/// Selects the faces of a mesh, which has this index among the objects, whose surfaces are flagged.
void select_surfaces(const grf::Mesh& mesh, std::uint32_t index, const std::vector<bool>& surfaces,
                     FaceSelection& selection);

/// Flags the surfaces of a mesh that selected faces have.
std::vector<bool> selected_surfaces(const SceneObjects& objects, const FaceSelection& selection,
                                    std::uint32_t mesh);

/// Grows the selection by all faces that share an edge with it; vertices at the same position count as one.
FaceSelection grown(const FaceSelection& selection, const SceneObjects& objects);

/// Shrinks the selection by the faces that share an edge with an unselected one.
FaceSelection shrunk(const FaceSelection& selection, const SceneObjects& objects);

/// All faces connected to the selection by shared edges.
FaceSelection connected(const FaceSelection& selection, const SceneObjects& objects);

/// The connected faces whose normal deviates by at most so many radians from that of the selected face from
/// which they were reached.
FaceSelection coplanar(const FaceSelection& selection, const SceneObjects& objects, double radians);

}  // namespace editor
