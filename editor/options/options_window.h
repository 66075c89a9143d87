#pragma once

#include <QMainWindow>

#include "editor/options/options_editor.h"

namespace editor {

/// The render options as a separate window. Its title has the file and whether it is saved; closing asks
/// about unsaved changes.
class OptionsWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit OptionsWindow(QWidget* parent = nullptr) : OptionsWindow(nullptr, parent) {}
  /// Edits a project's options, which outlive the window. Closing it asks nothing, since the project saves
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
