// Which faces are selected, and the ways to select more or fewer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <boost/dynamic_bitset.hpp>

#include "editor/document/scene_objects.h"

namespace editor {

/// A face of a mesh, each an index of its list.
struct FaceId {
  std::uint32_t mesh = 0;
  std::uint32_t face = 0;

  bool operator==(const FaceId&) const = default;
};

/// A set of faces of the meshes of a scene's objects. A mesh that stands at several places is selected in
/// all.
class FaceSelection {
 public:
  /// The bits say which faces of a mesh are selected.
  using Faces = boost::dynamic_bitset<>;

  FaceSelection() = default;
  /// No face of these.
  explicit FaceSelection(const SceneObjects& objects);

  std::size_t count() const { return count_; }
  bool empty() const { return count_ == 0; }
  bool has(FaceId face) const { return faces_[face.mesh][face.face]; }
  std::size_t mesh_count() const { return faces_.size(); }
  const Faces& of_mesh(std::uint32_t mesh) const { return faces_[mesh]; }
  /// How many faces of a mesh are selected.
  std::size_t count(std::uint32_t mesh) const { return counts_[mesh]; }
  /// Calls an action with the number of each selected face of a mesh, in time that is proportional to these.
  template <class Action>
  void for_each_face(std::uint32_t mesh, const Action& action) const {
    const Faces& faces = faces_[mesh];
    if (counts_[mesh] == 0) return;
    for (auto face = faces.find_first(); face != Faces::npos; face = faces.find_next(face)) action(face);
  }
  /// Those of which some, but perhaps not all, faces are selected.
  std::vector<std::uint32_t> meshes() const;

  void set(FaceId face, bool is_selected = true);
  void set_mesh(std::uint32_t mesh, bool is_selected = true);
  /// Selects these faces of a mesh alone; as many bits as it has faces.
  void set_faces(std::uint32_t mesh, const Faces& faces);
  void clear();
  void select_all();
  void invert();
  /// Adds or takes away what another selection of the same objects has.
  void add(const FaceSelection& other);
  void remove(const FaceSelection& other);

  bool operator==(const FaceSelection&) const = default;

 private:
  void count_faces(std::uint32_t mesh);

  std::vector<Faces> faces_;
  std::vector<std::size_t> counts_;  ///< of each mesh
  std::size_t count_ = 0;
};

/// Says which of the surfaces of a mesh, by its number, selected faces have.
std::vector<bool> selected_surfaces(const SceneObjects& objects, const FaceSelection& selection,
                                    std::uint32_t mesh);

/// The selection and all faces that share an edge with one of it; vertices at one place count as one.
FaceSelection grown(const FaceSelection& selection, const SceneObjects& objects);

/// The selection without the faces that share an edge with one that is not of it.
FaceSelection shrunk(const FaceSelection& selection, const SceneObjects& objects);

/// All faces that hang together with those of the selection by shared edges.
FaceSelection connected(const FaceSelection& selection, const SceneObjects& objects);

/// The same, where the normal of each turns no more than so many radians from that of the selected face which
/// it was reached from.
FaceSelection coplanar(const FaceSelection& selection, const SceneObjects& objects, double radians);

/// What two surfaces have to have in common to be alike.
enum class Likeness { Brdf, Pdf, Colour, Texture, Emission, All };

/// All faces of all meshes whose surface is like that of a selected one.
FaceSelection alike(const FaceSelection& selection, const SceneObjects& objects, Likeness likeness);

}  // namespace editor
