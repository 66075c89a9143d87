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

/// An OP file that is being edited, with undo and the diagnostics of `bpt`. The render options of a scene are
/// one of these, whose undo steps are on the stack of the scene.
class OpDocument : public QObject {
  Q_OBJECT

 public:
  /// The undo steps are on the stack of a project, which outlives it, or on its own.
  explicit OpDocument(EditStack* project = nullptr, QObject* parent = nullptr);

  /// Replaces the text by that of a file: in a project, as an undo step. Returns false, and changes nothing,
  /// if the file cannot be read.
  bool open(const QString& path, grf::Diagnostics& diagnostics);
  /// Writes the text as it is; a project's text keeps its path.
  bool save(const QString& path, grf::Diagnostics& diagnostics);
  /// Reads the file beside a scene, or starts with no text if there is none, without an undo step; errors of
  /// the file are in `diagnostics()`.
  void open_beside(const QString& scene_path);
  /// Writes the options, and the scene's name, to the file beside a scene. Changes of the file since it was
  /// read are kept, except for options that differ here. Returns false after an error.
  bool save_beside(const QString& scene_path, grf::Diagnostics& diagnostics);
  /// A snapshot for saving, which any thread may write; it returns no text after an error. Edits made
  /// meanwhile are kept when the saved text is taken over.
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
  /// Sets a text as if it had been read, such as that of a scene's default options, which has no file yet.
  /// `problems` replace the diagnostics of the text.
  void start(const std::string& text, const QString& path = {}, const grf::Diagnostics& problems = {});

  const QString& path() const { return path_; }
  const options::OpText& op_text() const { return text_; }
  /// The options as far as they can be parsed, also if the text has errors.
  options::RenderOptions partial_options() const { return text_.options(); }
  /// The options, or nothing if the text has errors, such as a missing scene name, which a project's options
  /// do not need. Paths are as `read_op_file` makes them.
  const std::optional<options::RenderOptions>& render_options() const { return render_options_; }
  /// The options of the last text without errors, except perhaps a missing scene. Their paths are absolute.
  const options::RenderOptions& valid_options() const { return valid_options_; }
  /// Errors, and warnings about options without effect.
  const grf::Diagnostics& diagnostics() const { return diagnostics_; }
  /// Whether the text must be written to keep the options of a scene that is saved under its own name, or
  /// under another one.
  bool is_edited() const { return is_edited_; }
  bool is_from_file() const { return !read_text_.empty(); }
  bool is_in_project() const { return stack_ != &own_stack_; }

  /// Sets the words of an option; none unset it. Edits of one option are merged into one undo step until
  /// `finish_step`.
  void set_words(const options::OptionInfo& option, const QStringList& words);
  /// Sets the text as text fields have it, with `\n` at the end of each line. Edits of one line are merged,
  /// likewise.
  void set_plain_text(const QString& plain);
  /// Sets the options that differ from `valid_options`. Steps with the same key are merged, likewise; an
  /// empty key never merges.
  void set_options(const QString& title, const options::RenderOptions& wanted, const QString& key = {});
  /// Sets the options without an undo step, for changes that follow another one, such as of the camera.
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
  /// Sets a text that equals that of its file.
  void take_file(const std::string& text, const QString& path);
  void check();

  EditStack own_stack_;
  EditStack* stack_;
  options::OpText text_;
  QString path_;
  std::string read_text_;  ///< text of the file when it was read or saved
  std::optional<options::RenderOptions> render_options_;
  options::RenderOptions valid_options_;
  grf::Diagnostics diagnostics_;
  bool is_edited_ = false;
  int step_ = 0;
};

}  // namespace editor
