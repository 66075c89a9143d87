#pragma once

#include <QMainWindow>

#include "editor/options/options_editor.h"

namespace editor {

/// The OP generator as a window of its own. Its title says the file and whether it is saved; closing asks
/// about what is not.
class OptionsWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit OptionsWindow(QWidget* parent = nullptr) : OptionsWindow(nullptr, parent) {}
  /// The window edits a project's options, which outlive it. Closing it asks nothing, since the project saves
  /// them.
  explicit OptionsWindow(OpDocument* project, QWidget* parent = nullptr);

  OptionsEditor& editor() { return *editor_; }

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  void make_menus();
  void show_title();

  OptionsEditor* editor_;
};

}  // namespace editor
