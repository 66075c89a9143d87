#include "editor/options/options_window.h"

#include <QAction>
#include <QCloseEvent>
#include <QFileInfo>
#include <QLineEdit>
#include <QMenuBar>
#include <QMessageBox>

#include "editor/appearance/theme.h"
#include "editor/options/options_form.h"

namespace editor {

OptionsWindow::OptionsWindow(OpDocument* project, QWidget* parent)
    : QMainWindow(parent), editor_(new OptionsEditor(project, this)) {
  setCentralWidget(editor_);
  resize(140 * Grid, 100 * Grid);
  make_menus();
  connect(&editor_->document(), &OpDocument::path_changed, this, &OptionsWindow::show_title);
  connect(&editor_->document().undo_stack(), &QUndoStack::cleanChanged, this,
          [this](bool is_clean) { setWindowModified(!is_clean); });
  show_title();
}

void OptionsWindow::show_title() {
  const QString path = editor_->document().path();
  setWindowTitle(
      tr("%1[*] - options - wannabe").arg(path.isEmpty() ? tr("untitled.op") : QFileInfo(path).fileName()));
}

void OptionsWindow::make_menus() {
  const auto add = [](QMenu* menu, QAction* action, const QKeySequence& key) {
    action->setShortcut(key);
    menu->addAction(action);
  };
  QMenu* file = menuBar()->addMenu(tr("&File"));
  add(file, editor_->open_action(), QKeySequence::Open);
  add(file, editor_->save_action(), QKeySequence::Save);
  add(file, editor_->save_as_action(), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S));
  file->addSeparator();
  QAction* close = file->addAction(tr("&Close"), this, &QWidget::close);
  close->setShortcut(QKeySequence::Close);
  close->setToolTip(tr("Close this window"));
  QMenu* edit = menuBar()->addMenu(tr("&Edit"));
  add(edit, editor_->undo_action(), QKeySequence::Undo);
  add(edit, editor_->redo_action(), QKeySequence::Redo);
  QAction* search = edit->addAction(tr("&Search options"), this,
                                    [this] { editor_->form().search()->setFocus(Qt::ShortcutFocusReason); });
  search->setShortcut(QKeySequence::Find);
  search->setToolTip(tr("Find options by name or meaning"));
}

void OptionsWindow::closeEvent(QCloseEvent* event) {
  OpDocument& document = editor_->document();
  if (!document.is_in_project() && !document.undo_stack().isClean()) {
    const auto answer = QMessageBox::question(
        this, tr("Unsaved options"), tr("The options have unsaved changes."),
        QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
    const bool may_close = answer == QMessageBox::Discard || (answer == QMessageBox::Save && editor_->save());
    if (!may_close) return event->ignore();
  }
  event->accept();
}

}  // namespace editor
