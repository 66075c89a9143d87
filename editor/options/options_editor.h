#pragma once

#include <QWidget>

#include "editor/document/op_document.h"
#include "renderer/options/render_options.h"

class QAction;
class QListWidget;

namespace editor {

class OptionsForm;
class OpTextView;

/// Edits an OP file: a form of all options at the left, the file's text at the right, and its diagnostics
/// under it. Each message leads to its control or line.
class OptionsEditor : public QWidget {
  Q_OBJECT

 public:
  /// Edits a project's options, which outlive the editor, or an OP file of its own.
  explicit OptionsEditor(OpDocument* project, QWidget* parent = nullptr);
  explicit OptionsEditor(QWidget* parent = nullptr) : OptionsEditor(nullptr, parent) {}

  OpDocument& document() { return document_; }
  /// Returns false after an error, which the messages show.
  bool open(const QString& path);
  bool save(const QString& path);
  /// Saves to the current file; asks for one if there is none.
  bool save();
  bool save_as();

  QListWidget& messages() { return *messages_; }
  OptionsForm& form() { return *form_; }
  /// Actions for menus; they have no shortcuts, which belong to the window.
  QAction* open_action() const { return open_; }
  QAction* save_action() const { return save_; }
  QAction* save_as_action() const { return save_as_; }
  QAction* undo_action() const { return undo_; }
  QAction* redo_action() const { return redo_; }

 signals:
  /// Emitted with the diagnostics of reading or writing a file.
  void reported(const grf::Diagnostics& diagnostics);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void make_actions();
  void lay_out();
  void show_messages();
  void add_message(const grf::Diagnostic& entry);
  void follow_message(int row);
  void ask_for_file();
  bool report(const grf::Diagnostics& diagnostics, bool is_done);

  OpDocument own_document_;
  OpDocument& document_;
  OptionsForm* form_;
  OpTextView* text_;
  QListWidget* messages_;
  grf::Diagnostics file_problems_;
  QAction* open_ = nullptr;
  QAction* save_ = nullptr;
  QAction* save_as_ = nullptr;
  QAction* undo_ = nullptr;
  QAction* redo_ = nullptr;
};

}  // namespace editor
