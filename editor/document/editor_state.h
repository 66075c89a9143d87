// The editor stores hidden, locked and named sets of faces beside a scene, in the sidecar
// SCENE.grf.editor.json.
#pragma once

#include <QString>
#include <map>
#include <string>
#include <vector>

#include "editor/document/face_selection.h"
#include "grf/diagnostics.h"

namespace editor {

/// Sets of faces that are no part of the scene. All sets are of the same objects.
struct EditorState {
  FaceSelection hidden;
  FaceSelection locked;
  std::map<std::string, FaceSelection> face_sets;  ///< by name

  EditorState() = default;
  /// Constructs empty sets, without named ones.
  explicit EditorState(const SceneObjects& objects) : hidden(objects), locked(objects) {}

  /// Whether no face is hidden or locked, and there is no named set.
  bool empty() const { return hidden.empty() && locked.empty() && face_sets.empty(); }
  /// Removes the hidden and locked faces from a selection of the same objects.
  FaceSelection selectable(FaceSelection faces) const;
  /// Returns the state for the objects after an edit.
  EditorState carried_over(const FaceCorrespondence& correspondence) const;

  bool operator==(const EditorState&) const = default;
};

/// The hidden, locked and named faces of meshes that edits removed. They come back with the mesh when the
/// edit is undone, or when the edit that added it is redone.
class RemovedFaces {
 public:
  void clear() { meshes_.clear(); }
  /// Remembers the faces of the meshes that an edit removes.
  void remember(const EditorState& state, const SceneObjects& before,
                const FaceCorrespondence& correspondence);
  /// Restores the faces of meshes that an edit brings back into a state of the objects after the edit. A
  /// named set that was removed meanwhile stays removed.
  void restore(EditorState& state, const SceneObjects& now, const FaceCorrespondence& correspondence);

 private:
  struct RemovedMesh {
    grf::Shared<grf::Mesh> mesh;
    grf::ScenePath path;
    FaceSelection::Faces hidden;
    FaceSelection::Faces locked;
    std::map<std::string, FaceSelection::Faces> face_sets;
  };

  std::vector<RemovedMesh> meshes_;
};

/// The path of the editor's file beside a scene, SCENE.grf.editor.json.
QString editor_file_beside(const QString& scene_path);

/// Reads the editor's file beside a scene; without one the state is empty. A file that cannot be read, or
/// that describes other meshes than the scene has, is one warning: what fits is read.
EditorState read_editor_state(const QString& scene_path, const SceneObjects& objects,
                              grf::Diagnostics& diagnostics);

/// Replaces the editor's file beside a scene atomically, or removes it if the state is empty. Returns false
/// after an error.
bool write_editor_state(const EditorState& state, const SceneObjects& objects, const QString& scene_path,
                        grf::Diagnostics& diagnostics);

}  // namespace editor
