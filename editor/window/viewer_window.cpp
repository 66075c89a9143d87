#include "editor/window/viewer_window.h"

#include <QAction>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileInfo>
#include <QLabel>
#include <QMenuBar>
#include <QMimeData>
#include <QSettings>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolBar>
#include <QVBoxLayout>

#include "editor/appearance/icons.h"
#include "editor/appearance/theme.h"
#include "editor/controls/counted.h"
#include "editor/controls/form_widgets.h"
#include "editor/controls/notice_bar.h"
#include "editor/view/scene_view.h"
#include "editor/window/file_actions.h"
#include "editor/window/source_view.h"
#include "editor/window/view_actions.h"

namespace editor {
namespace {

QString counts_of(const SceneObjects& objects) {
  return QString("%1, %2").arg(
      counted(objects.faces, ViewerWindow::tr("1 face"), ViewerWindow::tr("%1 faces")),
      counted(objects.triangles, ViewerWindow::tr("1 triangle"), ViewerWindow::tr("%1 triangles")));
}

}  // namespace

ViewerWindow::ViewerWindow(QWidget* parent)
    : QMainWindow(parent),
      notice_(new NoticeBar),
      pages_(new QStackedWidget),
      hint_(new QLabel),
      view_(new SceneView),
      pointed_(new QLabel),
      selected_(new QLabel),
      warnings_(new QLabel),
      counts_(new QLabel) {
  setAcceptDrops(true);
  setWindowTitle(tr("GRF viewer"));
  lay_out();
  make_status_line();
  add_file_actions();
  add_view_actions();
  connect(&loader_, &SceneLoader::files_known, &watch_, &FileWatch::follow);
  connect(&loader_, &SceneLoader::loaded, this, &ViewerWindow::show_scene);
  connect(&loader_, &SceneLoader::failed, this, &ViewerWindow::show_failure);
  connect(&watch_, &FileWatch::changed, this, &ViewerWindow::reload);
  connect(view_, &SceneView::hovered, this, [this](const QString& text) {
    if (!text.isEmpty()) statusBar()->clearMessage();
    pointed_->setText(text);
  });
  connect(view_, &SceneView::message, statusBar(),
          [this](const QString& text) { statusBar()->showMessage(text); });
  connect(view_, &SceneView::selection_made, this, &ViewerWindow::show_selection);
  // A dragged object returns to its position in the scene.
  connect(view_, &SceneView::object_moved, this, [this] {
    view_->show(view_->shared_objects());
    statusBar()->showMessage(tr("The viewer moves nothing: open the scene in the editor for that"));
  });
  resize(1024, 768);
  restoreGeometry(QSettings().value("viewer/geometry").toByteArray());
}

ViewerWindow::~ViewerWindow() = default;

void ViewerWindow::lay_out() {
  hint_->setText(tr("No scene is open.\n\nOpen a file (Ctrl+O), or drop one here."));
  hint_->setAlignment(Qt::AlignCenter);
  hint_->setWordWrap(true);
  hint_->setAutoFillBackground(true);
  hint_->setBackgroundRole(QPalette::Base);
  view_->setAccessibleName(tr("Scene"));
  pages_->addWidget(hint_);
  pages_->addWidget(view_);
  auto* middle = new QWidget;
  auto* layout = tight_layout<QVBoxLayout>(middle, 0);
  layout->addWidget(notice_);
  layout->addWidget(pages_, 1);
  setCentralWidget(middle);
}

void ViewerWindow::make_status_line() {
  pointed_->setAccessibleName(tr("What is under the pointer"));
  pointed_->setContentsMargins(Grid, 0, 0, 0);
  pointed_->setTextFormat(Qt::PlainText);
  pointed_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  statusBar()->addWidget(pointed_, 1);
  selected_->setAccessibleName(tr("Selected faces"));
  warnings_->setAccessibleName(tr("Warnings"));
  counts_->setAccessibleName(tr("Size of the scene"));
  counts_->setToolTip(
      tr("Faces of all meshes, each mesh counted once, and triangles, each instance counted"));
  for (QLabel* label : {selected_, warnings_, counts_}) {
    label->setContentsMargins(Grid, 0, Grid, 0);
    statusBar()->addPermanentWidget(label);
  }
}

void ViewerWindow::add_file_actions() {
  QMenu* menu = menuBar()->addMenu(tr("&File"));
  menu->setToolTipsVisible(true);
  const auto add = [this, menu](const QString& text, const char* icon_name, const QList<QKeySequence>& keys,
                                const QString& tip, auto slot) {
    QAction* action = menu->addAction(icon(icon_name), text);
    action->setShortcuts(keys);
    action->setToolTip(tip);
    action->setStatusTip(tip);
    connect(action, &QAction::triggered, this, slot);
    return action;
  };
  add(tr("&Open..."), "open", {QKeySequence::Open}, tr("Open a scene, or a model of another format"),
      &ViewerWindow::ask_for_file);
  reload_ = add(tr("&Reload"), "reset", {QKeySequence(Qt::Key_F5), QKeySequence("Ctrl+R")},
                tr("Nothing to reload: open a file first"), &ViewerWindow::reload);
  reload_->setEnabled(false);
  menu->addSeparator();
  add(tr("&Close"), "close", {QKeySequence("Ctrl+W"), QKeySequence("Ctrl+Q")}, tr("Close the window"),
      &ViewerWindow::close);
}

void ViewerWindow::add_view_actions() {
  auto* actions = new ViewActions(*view_, *this);
  QMenu* menu = menuBar()->addMenu(tr("&View"));
  menu->setToolTipsVisible(true);
  actions->fill(*menu);
  QToolBar* bar = addToolBar(tr("View"));
  bar->setObjectName("view");
  bar->setMovable(false);
  actions->fill(*bar);
}

void ViewerWindow::ask_for_file() { open(ask_for_scenes_or_models(*this, tr("Open")).value(0)); }

void ViewerWindow::open(const QString& file) {
  if (file.isEmpty()) return;
  path_ = QFileInfo(file).absoluteFilePath();
  // Watches from now on, so that a change while reading is noticed.
  watch_.follow({path_});
  reload_->setEnabled(true);
  reload_->setToolTip(tr("Reload the file; this also happens when the file changes"));
  reload_->setStatusTip(reload_->toolTip());
  reload();
}

void ViewerWindow::reload() {
  if (path_.isEmpty()) return;
  statusBar()->showMessage(tr("Reading %1").arg(QFileInfo(path_).fileName()));
  loader_.start(path_);
}

void ViewerWindow::show_scene(const std::shared_ptr<const LoadedScene>& scene) {
  statusBar()->clearMessage();
  notice_->hide();
  pages_->setCurrentWidget(view_);
  pages_->layout()->activate();
  view_->show(scene->objects);
  if (!shown_ || scene->path != shown_->path) {
    view_->frame_all();
    view_->setFocus();
  }
  shown_ = scene;
  setWindowTitle(tr("%1 - GRF viewer").arg(QFileInfo(scene->path).fileName()));
  counts_->setText(counts_of(*scene->objects));
  show_selection();
  show_warnings(warnings_of(*scene));
  emit opened(scene->path);
}

void ViewerWindow::show_failure(const LoadFailure& failure) {
  statusBar()->clearMessage();
  std::vector<NoticeBar::Choice> choices;
  if (failure.location.file) {
    choices.push_back({tr("Show the line"), tr("Show the line of the file with the error"),
                       [this, location = failure.location] { show_line(location); }});
  }
  QString text = failure.message;
  if (shown_) {
    text += shown_->path == failure.path ? tr("\nThe previous version is still shown.")
                                         : tr("\n%1 is still shown.").arg(QFileInfo(shown_->path).fileName());
  }
  notice_->show_notice(NoticeBar::Kind::Error, text, choices);
  emit failed(failure.message);
}

void ViewerWindow::show_line(const grf::SourceLocation& location) {
  if (!source_) {
    source_ = std::make_unique<SourceView>();
    source_->setWindowTitle(tr("Source text - GRF viewer"));
  }
  source_->show(location);
  source_->show();
  source_->raise();
  source_->activateWindow();
}

void ViewerWindow::show_selection() {
  const std::size_t count = view_->selection().count();
  selected_->setText(count == 0 ? QString() : tr("%1 selected").arg(count_text(count)));
  selected_->setVisible(count > 0);
}

void ViewerWindow::show_warnings(const QStringList& warnings) {
  constexpr int MostLines = 12;
  warnings_->setText(counted(static_cast<std::size_t>(warnings.size()), tr("1 warning"), tr("%1 warnings")));
  warnings_->setVisible(!warnings.isEmpty());
  QStringList lines = warnings.mid(0, MostLines);
  if (warnings.size() > MostLines) lines.append(tr("and %1 more").arg(warnings.size() - MostLines));
  warnings_->setToolTip(lines.join('\n'));
}

void ViewerWindow::closeEvent(QCloseEvent* event) {
  QSettings().setValue("viewer/geometry", saveGeometry());
  source_.reset();
  QMainWindow::closeEvent(event);
}

void ViewerWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (!local_files(*event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void ViewerWindow::dropEvent(QDropEvent* event) {
  const QString file = local_files(*event->mimeData()).value(0);
  if (file.isEmpty()) return;
  event->acceptProposedAction();
  open(file);
}

}  // namespace editor
