#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <QUndoStack>
#include <optional>

#include "grf/diagnostics.h"
#include "renderer/options/op_text.h"

namespace editor {

/// An OP file that is being edited, with undo, and with what `bpt` would say of it.
class OpDocument : public QObject {
  Q_OBJECT

 public:
  explicit OpDocument(QObject* parent = nullptr);

  /// The text of the file, in place of what is there; false, and nothing happens, if it cannot be read.
  bool open(const QString& path, grf::Diagnostics& diagnostics);
  bool save(const QString& path, grf::Diagnostics& diagnostics);
  /// A new text that has no file yet, such as that of a scene's default options.
  void start(const std::string& text, const QString& path = {});

  const QString& path() const { return path_; }
  const options::OpText& op_text() const { return text_; }
  /// What can be made of the text, also if something is wrong with it.
  options::RenderOptions partial_options() const { return text_.options(); }
  /// Nothing if there are errors. Paths are as `read_op_file` makes them.
  const std::optional<options::RenderOptions>& render_options() const { return render_options_; }
  /// Errors, and warnings of options that have no effect.
  const grf::Diagnostics& diagnostics() const { return diagnostics_; }

  /// Words of an option; none: it is not given. Edits of one option are one step of undo until `finish_step`.
  void set_words(const options::OptionInfo& option, const QStringList& words);
  /// As text fields have it, with `\n` at the end of each line.
  void set_plain_text(const QString& plain);
  void finish_step() { ++step_; }

  QUndoStack& undo_stack() { return stack_; }

 signals:
  void changed();
  void path_changed();

 private:
  class Edit;

  void push(const options::OpText& text, const QString& title, const void* subject);
  void take(const std::string& text);
  void check();

  QUndoStack stack_;
  options::OpText text_;
  QString path_;
  std::optional<options::RenderOptions> render_options_;
  grf::Diagnostics diagnostics_;
  int step_ = 0;
};

}  // namespace editor
