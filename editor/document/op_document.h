#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <optional>
#include <string>

#include "editor/document/edit_stack.h"
#include "grf/diagnostics.h"
#include "renderer/options/op_text.h"

namespace editor {

/// An OP file that is being edited, with undo, and with what `bpt` would say of it. The options of a scene
/// are one of these: its steps of undo are among those of the scene.
class OpDocument : public QObject {
  Q_OBJECT

 public:
  /// The steps of undo are among those of a project, which outlives it, or are its own.
  explicit OpDocument(EditStack* project = nullptr, QObject* parent = nullptr);

  /// The text of the file, in place of what is there: in a project, a step of undo. False, and nothing
  /// happens, if it cannot be read.
  bool open(const QString& path, grf::Diagnostics& diagnostics);
  /// Writes the text as it is; a project's text keeps its path.
  bool save(const QString& path, grf::Diagnostics& diagnostics);
  /// Takes the file beside a scene, or no text if there is none, as though it had always been here; what is
  /// wrong with the file is in `diagnostics()`.
  void open_beside(const QString& scene_path);
  /// Writes the options to the file beside a scene, and names the scene there. What was changed in that file
  /// since it was read stays, but for options that are others here. False after an error.
  bool save_beside(const QString& scene_path, grf::Diagnostics& diagnostics);
  /// The state that is saved so. Any thread may write it; nothing is its text after an error. What was edited
  /// meanwhile stays when the text is taken.
  struct Snapshot {
    std::string text;
    QString path;
    std::string read_text;
    options::RenderOptions options;
  };
  Snapshot snapshot() const { return {text_.text(), path_, read_text_, valid_options_}; }
  static std::optional<std::string> write_beside(const Snapshot& snapshot, const QString& scene_path,
                                                 grf::Diagnostics& diagnostics);
  void take_written(const Snapshot& snapshot, const QString& scene_path, const std::string& text);
  /// Takes a text as though it had been read, such as that of a scene's default options, which has no file
  /// yet. `problems` are said in place of what is wrong with the text.
  void start(const std::string& text, const QString& path = {}, const grf::Diagnostics& problems = {});

  const QString& path() const { return path_; }
  const options::OpText& op_text() const { return text_; }
  /// The options are what can be made of the text, also if something is wrong with it.
  options::RenderOptions partial_options() const { return text_.options(); }
  /// The options are nothing if the text has errors, such as that no scene is named, which a project's
  /// options need not. Paths are as `read_op_file` makes them.
  const std::optional<options::RenderOptions>& render_options() const { return render_options_; }
  /// The options are those of the last text that had no errors, but perhaps no scene. Their paths are
  /// absolute.
  const options::RenderOptions& valid_options() const { return valid_options_; }
  /// Errors, and warnings of options that have no effect.
  const grf::Diagnostics& diagnostics() const { return diagnostics_; }
  /// Whether the text has to be written to keep the options of a scene that is saved under its own name, or
  /// under another one.
  bool is_edited() const { return is_edited_; }
  bool is_from_file() const { return !read_text_.empty(); }
  bool is_in_project() const { return stack_ != &own_stack_; }

  /// Words of an option; none: it is not given. Edits of one option are one step of undo until `finish_step`.
  void set_words(const options::OptionInfo& option, const QStringList& words);
  /// Takes a text as text fields have it, with `\n` at the end of each line. Edits of one line are one step,
  /// likewise.
  void set_plain_text(const QString& plain);
  /// Changes those options that differ from `valid_options`. Steps with one key are one, likewise; an empty
  /// key is like no other.
  void set_options(const QString& title, const options::RenderOptions& wanted, const QString& key = {});
  /// The same, but no step: what follows something else, such as a camera, is not an edit.
  void follow(const options::RenderOptions& wanted);
  void finish_step() { ++step_; }

  QUndoStack& undo_stack() { return *stack_; }

 signals:
  void changed();
  void path_changed();

 private:
  class Edit;

  std::optional<options::OpText> text_with(const options::RenderOptions& wanted) const;
  void push(const options::OpText& text, const QString& title, const QString& key);
  void take(const std::string& text);
  /// Takes a text that is the same as that of its file.
  void take_file(const std::string& text, const QString& path);
  void check();

  EditStack own_stack_;
  EditStack* stack_;
  options::OpText text_;
  QString path_;
  std::string read_text_;  ///< what the file had when it was read or saved
  std::optional<options::RenderOptions> render_options_;
  options::RenderOptions valid_options_;
  grf::Diagnostics diagnostics_;
  bool is_edited_ = false;
  int step_ = 0;
};

}  // namespace editor
