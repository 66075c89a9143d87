#pragma once

#include <QObject>
#include <QString>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "editor/document/change.h"
#include "editor/document/edit_stack.h"
#include "editor/document/face_selection.h"
#include "editor/document/import_folder.h"
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

/// A scene of the file `from` as the file `to` would name others. Without a path, names begin in the current
/// folder.
grf::Scene moved(grf::Scene scene, const QString& from, const QString& to);

/// The project being edited: a scene, the options of its renders, and what is selected. Every change of scene
/// and options is an undo command of one stack; what is selected is not, but undo and redo select again what
/// their command was about.
class Document : public QObject {
  Q_OBJECT

 public:
  explicit Document(QObject* parent = nullptr);
  ~Document() override;

  const grf::Scene& scene() const { return scene_; }
  /// The scene's objects are what views draw: they are as old as the last `changed`.
  const SceneObjects& objects() const { return *objects_; }
  /// Shares the objects with who keeps them.
  const std::shared_ptr<const SceneObjects>& shared_objects() const { return objects_; }
  const FaceSelection& selection() const { return *selection_; }
  /// Where the scene was read from or saved; empty: nowhere yet.
  const QString& path() const { return path_; }
  /// The file's name for titles; `Untitled` if there is none.
  QString name() const;
  bool is_modified() const { return saved_ != revision(); }
  /// The number of the present state: a state that undo or redo brings back has the number that it had.
  std::uint64_t revision() const { return undo_stack_.revision(); }
  QUndoStack& undo_stack() { return undo_stack_; }
  /// The options of renders: those of the OP file beside the scene, which is written where the scene is
  /// saved.
  OpDocument& options() { return options_; }
  const OpDocument& options() const { return options_; }
  /// What reading and checking the scene's file said.
  const grf::Diagnostics& diagnostics() const { return diagnostics_; }

  /// Begins anew, without a way back.
  void clear();
  /// Takes a scene as though it had been read from the path; a scene that was recovered is not as it is
  /// there.
  void take(grf::Scene scene, const QString& path, grf::Diagnostics diagnostics, bool is_modified = false);
  /// Takes a model that was imported, as a new scene that is not saved yet.
  void take_import(const ImportedModel& model);
  /// Adds the blocks of another scene, whose file is `path`, to this one, where its names are in scope: one
  /// step of undo.
  void merge(const QString& text, const grf::Scene& scene, const QString& path);
  void merge_import(const QString& text, const ImportedModel& model);
  /// Folders with images of models that were imported into this scene; they stay as long as someone has them.
  const ImportFolders& imports() const { return imports_; }
  void add_import(std::shared_ptr<const ImportFolder> folder);

  /// Writes the scene; names of other files follow it to another folder, and images that stood inside an
  /// imported model are copied there. After an error it is still modified.
  bool save(const QString& path, grf::Diagnostics& diagnostics);
  /// Save in two parts, so that the request can be written in a thread. What was edited meanwhile is not
  /// saved.
  SaveRequest save_request(const QString& path);
  void take_saved(const SaveResult& result);

  void select(FaceSelection selection);

  // Each edit is one step of undo; one that changes nothing is none. Steps with one key become one, until
  // `finish_gesture`; an empty key is like no other. What stands in a file that is included at several places
  // is edited at all of them.

  /// Brings the scene into another state.
  void replace(const QString& text, grf::Scene scene, const QString& key = {});
  /// Edits what the selected faces have. Nothing happens if none is selected.
  void edit_surfaces(const QString& text, const SurfaceEdits& edits, const QString& key = {});
  /// The next step is one of its own: a slider was let go.
  void finish_gesture();

 signals:
  void changed(const editor::Change& change);
  /// An edit changed more than was asked for, or was not made, and why.
  void told(const QString& message);
  void selection_changed();
  void path_changed();
  /// Another scene is edited from now on: it was opened, imported, recovered or begun anew.
  void taken();
  /// The scene that was taken has nothing that emits light: it has a grey sky until something does.
  void lit_by_a_plain_sky();
  /// After the scene was written.
  void saved();
  void modified_changed(bool is_modified);

 private:
  class Step;
  /// How names of other files were changed where the scene was saved to another folder.
  struct Relocation {
    std::string from;
    std::string to;
    std::map<std::string, std::string> moved;
  };

  void set_saved(std::optional<std::uint64_t> revision);
  void tell_of_places(std::size_t places);
  void push(const QString& text, ScenePatch patch, const QString& key);
  void set_background(const grf::Vec3f& radiance);
  void light_by_plain_sky();
  bool take_plain_sky();
  void show(grf::Scene scene);
  void show_change(const Change& change, const FaceSelection* selection);
  FaceSelection carried_over(const SceneObjects& before) const;
  Change change_of(const ScenePatch& patch) const;

  grf::Scene scene_;
  std::shared_ptr<const SceneObjects> objects_ = std::make_shared<const SceneObjects>();
  grf::Shared<FaceSelection> selection_;
  QString path_;
  grf::Diagnostics diagnostics_;
  ImportFolders imports_;
  std::vector<Relocation> relocations_;  ///< since the first step
  int gesture_ = 0;
  EditStack undo_stack_;
  std::uint64_t origin_ = 0;                ///< the revision with which the scene was taken
  std::optional<std::uint64_t> saved_ = 0;  ///< the revision that its file holds; none: it holds another one
  bool was_modified_ = false;
  OpDocument options_{&undo_stack_};
  bool has_plain_sky_ = false;
};

}  // namespace editor
