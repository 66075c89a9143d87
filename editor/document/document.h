#pragma once

#include <QByteArray>
#include <QObject>
#include <QString>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "editor/document/change.h"
#include "editor/document/edit_stack.h"
#include "editor/document/editor_state.h"
#include "editor/document/face_selection.h"
#include "editor/document/import_folder.h"
#include "editor/document/object_placement.h"
#include "editor/document/op_document.h"
#include "editor/document/scene_objects.h"
#include "editor/document/scene_patch.h"
#include "editor/document/surface_edits.h"
#include "grf/diagnostics.h"
#include "grf/scene.h"

namespace editor {

struct ImportedModel;
struct SaveRequest;
struct SaveResult;

/// Converts a scene's references to files from the file `from` to the file `to`. Without a path they are
/// relative to the current folder.
grf::Scene moved(grf::Scene scene, const QString& from, const QString& to);

/// The edited project: a scene, its render options, and the selection. Every change of scene and options is a
/// command on one undo stack; the selection is not, but undo and redo restore the selection of their command.
class Document : public QObject {
  Q_OBJECT

 public:
  explicit Document(QObject* parent = nullptr);
  ~Document() override;

  const grf::Scene& scene() const { return scene_; }
  /// The flattened scene that views draw, as of the last `changed`.
  const SceneObjects& objects() const { return *objects_; }
  /// The same, for sharing with views.
  const std::shared_ptr<const SceneObjects>& shared_objects() const { return objects_; }
  const FaceSelection& selection() const { return selection_; }
  /// The paths of the selected objects; the last one is the active one. Each leads to a block of the scene.
  const std::vector<grf::ScenePath>& selected_objects() const { return *selected_objects_; }
  /// The hidden, locked and named faces, of `objects`. They are no undo steps: an edit, undo or redo keeps
  /// those of meshes that are there before and after it, and those of a removed mesh come back with it.
  const EditorState& editor_state() const { return state_; }
  /// The file that the scene was read from or saved to; empty if there is none.
  const QString& path() const { return path_; }
  /// The file name for titles; `Untitled` if there is none.
  QString name() const;
  /// Whether the scene or the editor's state differ from their files.
  bool is_modified() const { return saved_ != revision() || !(state_ == saved_state_); }
  /// The number of the current state; undo and redo restore the number of their state.
  std::uint64_t revision() const { return undo_stack_.revision(); }
  EditStack& undo_stack() { return undo_stack_; }
  /// The render options: those of the OP file beside the scene, which is written when the scene is saved.
  OpDocument& options() { return options_; }
  const OpDocument& options() const { return options_; }
  /// Whether the scene has no lights, so that its options have a grey sky until it has one.
  bool has_plain_sky() const;
  /// The diagnostics of reading and checking the scene's file.
  const grf::Diagnostics& diagnostics() const { return diagnostics_; }

  /// Starts an empty scene. This cannot be undone.
  void clear();
  /// Sets a scene as if it had been read from the path, with the state of the editor's file beside it, which
  /// is ignored unless it is of the scene's objects. A recovered scene counts as modified.
  void take(grf::Scene scene, const QString& path, grf::Diagnostics diagnostics, EditorState state = {},
            bool is_modified = false);
  /// Sets an imported model as a new, unsaved scene.
  void take_import(const ImportedModel& model);
  /// Appends the blocks of another scene, whose file is `path`, in a scope of its names, as one undo step.
  void merge(const QString& text, const grf::Scene& scene, const QString& path);
  /// Appends models, as one undo step.
  void merge_imports(const QString& text, const std::vector<ImportedModel>& models);
  /// Folders with images of imported models; each is kept as long as it is referenced.
  const ImportFolders& imports() const { return imports_; }
  void add_import(std::shared_ptr<const ImportFolder> folder);

  /// Saves the scene; references to other files are adapted to its folder, and images embedded in imported
  /// models are copied there. After an error it is still modified.
  bool save(const QString& path, grf::Diagnostics& diagnostics);
  /// Save in two parts, so that the request can be written in a thread. Edits made meanwhile are not saved.
  SaveRequest save_request(const QString& path);
  void take_saved(const SaveResult& result);

  /// Selects faces; those that are hidden or locked are left out.
  void select(FaceSelection selection);
  /// Sets the hidden, locked and named faces, which must be of `objects`. Hidden and locked faces are
  /// deselected, and objects of which no face is visible.
  void set_editor_state(EditorState state);
  /// Selects objects; paths that lead to no block are left out.
  void select_objects(std::vector<grf::ScenePath> paths);

  // Each edit is one undo step, unless it changes nothing. Steps with the same key are merged until
  // `finish_gesture`; an empty key never merges. Edits of a file that is included at several places are
  // applied at all of them.

  /// Replaces the scene by an edited one.
  void replace(const QString& text, grf::Scene scene, const QString& key = {});
  /// Edits the surfaces of the selected faces. Does nothing if none is selected.
  void edit_surfaces(const QString& text, const SurfaceEdits& edits, const QString& key = {});
  /// Transforms the selected objects, which stay selected. Returns false, with a `status_message`, if that
  /// is not possible.
  bool transform_selected(const QString& text, const TransformAction& action);
  /// Replaces the scene by one in which the selected objects have other paths.
  void replace_objects(const QString& text, TransformedObjects edited, const QString& key = {});
  /// Edits the objects of the last step, which becomes the step to the edited scene: a new object got other
  /// parameters. Not after the scene was saved.
  void amend_objects(const QString& text, TransformedObjects edited);
  /// Ends the merging of steps: a slider was released.
  void finish_gesture();

 signals:
  void changed(const editor::Change& change);
  /// Emitted with a message if an edit changed more than requested, or failed.
  void status_message(const QString& message);
  void selection_changed();
  void selected_objects_changed();
  /// Emitted when faces were hidden, locked or named, or an edit renumbered such faces.
  void editor_state_changed();
  void path_changed();
  /// Emitted when another scene was opened, imported, recovered or started.
  void scene_replaced();
  /// Emitted when the new scene has no lights: it uses a grey sky until it has one.
  void scene_has_no_lights();
  /// Emitted after the scene was written.
  void saved();
  void modified_changed(bool is_modified);

 private:
  class Step;
  /// How references to files changed when the scene was saved to another folder.
  struct Relocation {
    std::string from;
    std::string to;
    std::map<std::string, std::string> moved;
  };

  void set_saved(std::optional<std::uint64_t> revision);
  void tell_of_places(std::size_t places);
  void push(const QString& text, ScenePatch patch, const QString& key,
            const std::optional<std::vector<grf::ScenePath>>& objects = std::nullopt, bool amends = false);
  void set_background(const grf::Vec3f& radiance);
  void light_by_plain_sky();
  bool take_plain_sky();
  void show(grf::Scene scene);
  void show_change(const Change& change, const QByteArray* selection,
                   const std::optional<std::vector<grf::ScenePath>>& selected_objects);
  void set_selection(FaceSelection selection);
  bool is_hidden(grf::ScenePathView object) const;
  const QByteArray& packed_selection();
  bool carry_state_over(const SceneObjects& before);
  bool set_selected_objects(std::vector<grf::ScenePath> paths);
  std::vector<grf::ScenePath> objects_carried_over(const SceneObjects& before) const;
  Change change_of(const ScenePatch& patch) const;

  grf::Scene scene_;
  std::shared_ptr<const SceneObjects> objects_ = std::make_shared<const SceneObjects>();
  FaceSelection selection_;
  QByteArray packed_selection_;  ///< of `selection_`; empty until a step needs it
  EditorState state_;
  EditorState saved_state_;  ///< that of its file
  RemovedFaces removed_faces_;
  grf::Shared<std::vector<grf::ScenePath>> selected_objects_;
  QString path_;
  grf::Diagnostics diagnostics_;
  ImportFolders imports_;
  std::vector<Relocation> relocations_;  ///< since the first step
  int gesture_ = 0;
  EditStack undo_stack_;
  std::uint64_t origin_ = 0;                ///< the revision with which the scene was set
  std::optional<std::uint64_t> saved_ = 0;  ///< the revision of its file; none if that holds another one
  bool was_modified_ = false;
  OpDocument options_{&undo_stack_};
  bool has_plain_sky_ = false;
};

}  // namespace editor
