#include "editor/window/main_window.h"

#include <QChildEvent>
#include <QCloseEvent>
#include <QDockWidget>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QStatusBar>
#include <QTabBar>
#include <QTimer>
#include <QToolBar>
#include <QUndoView>
#include <QVBoxLayout>

#include "editor/appearance/icons.h"
#include "editor/appearance/theme.h"
#include "editor/brdf/brdf_editor.h"
#include "editor/brdf/live_sphere.h"
#include "editor/controls/form_widgets.h"
#include "editor/controls/notice_bar.h"
#include "editor/panels/camera_panel.h"
#include "editor/panels/light_panel.h"
#include "editor/panels/message_panel.h"
#include "editor/panels/object_panel.h"
#include "editor/panels/scene_tree.h"
#include "editor/panels/surface_panel.h"
#include "editor/panels/uv_panel.h"
#include "editor/rendering/render_panel.h"
#include "editor/view/environment_store.h"
#include "editor/view/scene_view.h"
#include "editor/window/bake_controller.h"
#include "editor/window/brdf_controller.h"
#include "editor/window/effects_controller.h"
#include "editor/window/file_actions.h"
#include "editor/window/image_controller.h"
#include "editor/window/job_panel.h"
#include "editor/window/light_controller.h"
#include "editor/window/material_actions.h"
#include "editor/window/mesh_actions.h"
#include "editor/window/object_actions.h"
#include "editor/window/pages.h"
#include "editor/window/recovery_controller.h"
#include "editor/window/render_controller.h"
#include "editor/window/rendered_mode.h"
#include "editor/window/sample_scenes.h"
#include "editor/window/selection_actions.h"
#include "editor/window/shortcut_keys.h"
#include "editor/window/status_line.h"
#include "editor/window/view_actions.h"
#include "editor/window/view_controller.h"
#include "editor/window/visibility_actions.h"
#include "editor/window/welcome_controller.h"
#include "renderer/reflectance/scheme.h"

namespace editor {

MainWindow::MainWindow(const QString& sessions, QWidget* parent)
    : QMainWindow(parent),
      catalogue_(reflectance::catalogue()),
      docks_(*this),
      files_(new FileActions(document_, jobs_, *this)),
      view_(new SceneView),
      environment_(new EnvironmentStore),
      notice_(new NoticeBar),
      pages_(new Pages),
      status_(new StatusLine(document_, jobs_, *statusBar())),
      bake_(new BakeController(document_, jobs_, this)),
      recovery_(new RecoveryController(document_, jobs_, sessions, *files_, *notice_, this)) {
  setAcceptDrops(true);
  resize(200 * Grid, 125 * Grid);
  // Notices about the former scene are hidden; those about the new one follow.
  connect(&document_, &Document::scene_replaced, notice_, &QWidget::hide);
  make_docks();
  render_controller_ = new RenderController(document_, *view_, *render_, *cameras_, *this);
  view_controller_ = new ViewController(document_, catalogue_, *view_, *render_controller_, this);
  brdf_controller_ = new BrdfController(document_, *brdf_editor_, this);
  view_actions_ = new ViewActions(*view_, *this, true);
  rendered_mode_ = new RenderedMode(*view_, *render_, *this);
  selection_actions_ = new SelectionActions(document_, *view_, *this);
  visibility_actions_ = new VisibilityActions(document_, *view_, *this);
  object_actions_ = new ObjectActions(document_, *view_, *this);
  light_controller_ =
      new LightController(document_, *lights_, *view_controller_, *object_actions_, *notice_, this);
  material_actions_ = new MaterialActions(document_, *this);
  mesh_actions_ = new MeshActions(document_, jobs_, *this);
  effects_ = new EffectsController(document_, *render_, *pages_, *this);
  welcome_ = new WelcomeController(*this, *pages_, samples_folder());
  lay_out();
  make_menus();
  images_ = new ImageController(*render_, *pages_, *image_menu_, this);
  connect_files();
  connect_panels();
  connect_environment();
  connect_actions();
  connect_renders();
  docks_.keep_as_default();
  docks_.restore(QSettings());
  keys_ = std::make_unique<ShortcutKeys>(*this);
  apply_preferences(Preferences::load());
  show_title();
  show_status(tr("Open a scene or a model, or drop one here"));
  view_->setFocus();
}

MainWindow::~MainWindow() {
  // Widgets listen to the document until they are destroyed, which must be before it is.
  delete takeCentralWidget();
  for (QDockWidget* dock : findChildren<QDockWidget*>()) delete dock;
}

void MainWindow::lay_out() {
  auto* scene_page = new QWidget;
  auto* column = tight_layout<QVBoxLayout>(scene_page, 0);
  auto* bar = new QToolBar(tr("View"), scene_page);
  bar->setIconSize({2 * Grid + Grid / 4, 2 * Grid + Grid / 4});
  view_actions_->fill(*bar);
  bar->addSeparator();
  selection_actions_->fill(*bar);
  bar->addSeparator();
  object_actions_->fill(*bar);
  bar->addSeparator();
  render_controller_->fill(*bar);
  bar->addSeparator();
  bar->addAction(render_->preview_action());
  bar->addAction(render_->render_action());
  column->addWidget(bar);
  column->addWidget(view_, 1);
  view_->setMinimumSize(30 * Grid, 20 * Grid);

  pages_->add_scene(scene_page);
  auto* centre = new QWidget(this);
  auto* rows = tight_layout<QVBoxLayout>(centre, 0);
  rows->addWidget(notice_);
  rows->addWidget(pages_, 1);
  setCentralWidget(centre);
}

void MainWindow::make_docks() {
  setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks);
  setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
  tree_ = new SceneTree(document_);
  lights_ = new LightPanel(document_);
  object_ = new ObjectPanel(document_);
  cameras_ = new CameraPanel(document_);
  surface_ = new SurfacePanel(document_, catalogue_);
  brdf_editor_ = new BrdfEditor;
  uv_ = new UvPanel(document_);
  render_ = new RenderPanel(document_, jobs_);
  messages_ = new MessagePanel(document_, catalogue_);
  QDockWidget* tree = docks_.add({"scene", tr("Scene"), "objects", QKeySequence("Ctrl+1"),
                                  tr("Scene outliner: objects, lights and definitions")},
                                 Qt::LeftDockWidgetArea, tree_);
  QDockWidget* lights = docks_.add({"lights", tr("Lights"), "light", QKeySequence("Ctrl+2"),
                                    tr("Area lights, mesh lights and emissive faces of the scene")},
                                   Qt::LeftDockWidgetArea, lights_);
  object_dock_ = docks_.add({"object", tr("Object"), "transform", QKeySequence("Ctrl+9"),
                             tr("Position, rotation and scale of the selected object")},
                            Qt::LeftDockWidgetArea, object_);
  QDockWidget* cameras = docks_.add({"cameras", tr("Cameras"), "camera", QKeySequence("Ctrl+Alt+9"),
                                     tr("Cameras of the scene: position, lens and focus")},
                                    Qt::LeftDockWidgetArea, cameras_);
  QDockWidget* surface =
      docks_.add({"surface", tr("Surface"), "texture", QKeySequence("Ctrl+3"),
                  tr("Surface of the selected faces: BRDF, colour, texture, emission, normals")},
                 Qt::RightDockWidgetArea, surface_);
  brdf_dock_ =
      docks_.add({"brdf", tr("BRDF"), "brdf", QKeySequence("Ctrl+4"),
                  tr("BRDF of the selected faces: parameters such as roughness, lobe, plots and sphere")},
                 Qt::RightDockWidgetArea, brdf_editor_);
  QDockWidget* uv = docks_.add({"uv", tr("UV"), "grid", QKeySequence("Ctrl+Alt+U"),
                                tr("Texture coordinates (UVs) of the selected faces, over their image")},
                               Qt::RightDockWidgetArea, uv_);
  make_bottom_docks();
  auto* steps = new QUndoView(&document_.undo_stack());
  steps->setEmptyLabel(tr("Opened"));
  steps->setAccessibleName(tr("Undo steps"));
  steps->setToolTip(tr("All undo steps; a click goes back or forth to a step"));
  QDockWidget* history = docks_.add({"history", tr("History"), "undo", QKeySequence("Ctrl+Alt+H"),
                                     tr("The undo steps, to go back to any of them")},
                                    Qt::LeftDockWidgetArea, steps);
  splitDockWidget(tree, lights, Qt::Vertical);
  tabifyDockWidget(lights, object_dock_);
  tabifyDockWidget(object_dock_, cameras);
  tabifyDockWidget(cameras, history);
  lights->raise();
  splitDockWidget(surface, brdf_dock_, Qt::Vertical);
  tabifyDockWidget(brdf_dock_, uv);
  brdf_dock_->raise();
  resizeDocks({tree, surface}, {34 * Grid, 46 * Grid}, Qt::Horizontal);
  resizeDocks({tree, lights}, {70 * Grid, 40 * Grid}, Qt::Vertical);
  resizeDocks({surface, brdf_dock_}, {48 * Grid, 62 * Grid}, Qt::Vertical);
}

void MainWindow::make_bottom_docks() {
  render_dock_ = docks_.add(
      {"render", tr("Render"), "render", QKeySequence("Ctrl+5"), tr("Previews and renders of the scene")},
      Qt::BottomDockWidgetArea, render_);
  message_dock_ = docks_.add({"messages", tr("Messages"), "note", QKeySequence("Ctrl+6"),
                              tr("Errors and warnings about the scene and its file")},
                             Qt::BottomDockWidgetArea, messages_);
  job_dock_ = docks_.add({"jobs", tr("Jobs"), "jobs", QKeySequence("Ctrl+8"),
                          tr("Running and queued jobs, such as imports and renders")},
                         Qt::BottomDockWidgetArea, new JobPanel(jobs_));
  tabifyDockWidget(render_dock_, message_dock_);
  tabifyDockWidget(message_dock_, job_dock_);
  render_dock_->hide();
  message_dock_->hide();
  job_dock_->hide();
}

void MainWindow::connect_files() {
  connect(files_, &FileActions::done, this, &MainWindow::show_status);
  connect(files_, &FileActions::failed, this, &MainWindow::fail_file);
  connect(files_, &FileActions::reported, messages_, &MessagePanel::show_diagnostics);
  connect(&files_->outside_changes(), &OutsideChanges::found, this, &MainWindow::tell_of_outside_changes);
  connect(&jobs_, &JobList::failed, this, &MainWindow::fail);
  connect(&jobs_, &JobList::changed, this, [this] {
    const std::size_t count = jobs_.jobs().size();
    docks_.action_of(job_dock_)->setText(count == 0 ? tr("Jobs") : tr("Jobs (%1)").arg(count));
  });
  connect(&document_, &Document::scene_replaced, this, [this] { pages_->setCurrentIndex(0); });
  connect(&document_, &Document::path_changed, this, &MainWindow::show_title);
  connect(&document_, &Document::status_message, this, &MainWindow::show_status);
  connect(&document_, &Document::modified_changed, this, &MainWindow::show_title);
  connect(recovery_, &RecoveryController::status_message, this, &MainWindow::show_status);
  connect(recovery_, &RecoveryController::failed, this, &MainWindow::fail);
}

void MainWindow::connect_panels() {
  connect(view_, &SceneView::hovered, status_, &StatusLine::show_hovered);
  connect(view_, &SceneView::message, this, &MainWindow::show_status);
  connect(view_, &SceneView::warned, messages_, &MessagePanel::add_warning);
  connect(&brdf_editor_->sphere(), &LiveSphere::warned, messages_, &MessagePanel::add_warning);
  connect(view_controller_, &ViewController::failed, this, &MainWindow::fail);
  connect(view_controller_, &ViewController::status_message, this, &MainWindow::show_status);
  connect(view_controller_, &ViewController::texture_dropped, this, [this] {
    const DisplayMode mode = view_->mode();
    if (mode == DisplayMode::Solid || mode == DisplayMode::SolidEdges)
      view_actions_->set_mode(DisplayMode::Textured);
  });
  connect(brdf_controller_, &BrdfController::failed, this, &MainWindow::fail);
  connect(tree_, &SceneTree::chosen, this, [this](const grf::ScenePath& path) { lights_->choose(path); });
  connect(lights_, &LightPanel::chosen, this, [this](const grf::ScenePath& path) { tree_->choose(path); });
  connect(surface_, &SurfacePanel::brdf_edit_requested, this, [this] {
    Docks::show(brdf_dock_);
    brdf_editor_->form().setFocus();
  });
  connect(surface_, &SurfacePanel::pick_requested, this, [this] {
    view_controller_->pick({tr("Click the face to copy the surface from, or press Escape to cancel"),
                            [this](const SurfacePoint& point) { surface_->take_from(point.face); }});
  });
  connect(cameras_, &CameraPanel::focus_requested, this, [this] {
    view_controller_->pick({tr("Click what the camera shall focus on, or press Escape to cancel"),
                            [this](const SurfacePoint& point) { cameras_->focus_on(point.position); }});
  });
  connect(surface_, &SurfacePanel::bake_requested, bake_, &BakeController::bake);
  connect(messages_, &MessagePanel::place_requested, pages_, &Pages::show_source);
  connect(messages_, &MessagePanel::chosen, tree_,
          [this](const grf::ScenePath& path) { tree_->choose(path); });
  connect(messages_, &MessagePanel::messages_changed, this, [this] {
    const std::size_t errors = messages_->error_count();
    const std::size_t count = errors + messages_->warning_count();
    QAction* action = docks_.action_of(message_dock_);
    action->setText(count == 0 ? tr("Messages") : tr("Messages (%1)").arg(count));
    action->setIcon(icon(errors > 0 ? "error" : count > 0 ? "warning" : "note"));
  });
  connect(bake_, &BakeController::status_message, this, &MainWindow::show_status);
  connect(bake_, &BakeController::failed, this, &MainWindow::fail);
}

/// The view and the sphere of the BRDF dock show the environment of the render options.
void MainWindow::connect_environment() {
  environment_->setParent(this);
  connect(&document_.options(), &OpDocument::changed, environment_,
          [this] { environment_->set_options(document_.options().valid_options()); });
  connect(environment_, &EnvironmentStore::failed, this, &MainWindow::show_status);
  connect(environment_, &EnvironmentStore::changed, this, [this] {
    const auto& environment = environment_->environment();
    view_->set_environment(environment);
    const bool is_map = environment && environment->is_map();
    brdf_editor_->set_environment(is_map ? std::optional(environment->sky) : std::nullopt);
  });
  environment_->set_options(document_.options().valid_options());
}

void MainWindow::connect_actions() {
  connect(mesh_actions_, &MeshActions::status_message, this, &MainWindow::show_status);
  connect(mesh_actions_, &MeshActions::failed, this, &MainWindow::fail);
  connect(uv_, &UvPanel::edit_requested, mesh_actions_,
          [this](const QString& text, const UvTransform& transform) {
            mesh_actions_->start(text, document_.selection(), [transform](const SelectedFaces& faces) {
              return with_transformed_uvs(faces, transform);
            });
          });
  connect(material_actions_, &MaterialActions::status_message, this, &MainWindow::show_status);
  connect(material_actions_, &MaterialActions::failed, this, &MainWindow::fail);
  connect(object_actions_, &ObjectActions::surface_requested, this, [this](bool is_along_normal) {
    view_controller_->pick({tr("Click where the object shall stand, or press Escape to cancel"),
                            [this, is_along_normal](const SurfacePoint& point) {
                              object_actions_->place_on(point.position, is_along_normal
                                                                            ? std::optional(point.normal)
                                                                            : std::nullopt);
                            }});
  });
  connect(object_actions_, &ObjectActions::shape_added, this, [this](const PrimitiveShape& shape) {
    object_->show_new_shape(shape);
    Docks::show(object_dock_);
  });
  connect(object_actions_, &ObjectActions::status_message, this, &MainWindow::show_status);
  connect(effects_, &EffectsController::status_message, this, &MainWindow::show_status);
}

void MainWindow::connect_renders() {
  // Starting a render shows its dock.
  const auto show_render = [this] { Docks::show(render_dock_); };
  connect(render_->preview_action(), &QAction::triggered, this, show_render);
  for (const QAction* action : {render_->render_action(), render_->cameras_action(),
                                render_->effects_action(), render_->animation_action()}) {
    connect(action, &QAction::triggered, this, show_render);
  }
  connect(render_, &RenderPanel::preview_starting, light_controller_, &LightController::light_first_preview);
  connect(render_, &RenderPanel::op_file_differs, this, [this](const QString& path) {
    notice_->show_notice(
        NoticeBar::Kind::Information,
        tr("%1 differs from the current render settings. Saving the scene writes it, too.")
            .arg(QFileInfo(path).fileName()),
        {{tr("Write now"), tr("Write the current render settings to the file; its comments are kept"),
          [this] {
            grf::Diagnostics diagnostics;
            if (!document_.options().save_beside(document_.path(), diagnostics)) {
              fail(QString::fromStdString(diagnostics.to_text()));
            }
          }}});
  });
}

void MainWindow::show_scene() {
  pages_->setCurrentIndex(0);
  view_->setFocus(Qt::ShortcutFocusReason);
}

ImageBrowser& MainWindow::image_browser() { return images_->browser(); }

void MainWindow::tell_of_outside_changes(const QStringList& files) {
  notice_->show_notice(NoticeBar::Kind::Information,
                       tr("Another program has changed %1.").arg(files.join(", ")),
                       {{tr("Reload"), tr("Reload the scene; asks first if there are unsaved changes"),
                         [this] { files_->revert(); }},
                        {tr("Compare"), tr("Compare the scene with its file, line by line"),
                         [this] { pages_->show_differences(document_.scene(), document_.path()); }},
                        {tr("Keep mine"), tr("Keep the scene as it is here; saving overwrites the file"),
                         [this] { files_->outside_changes().ignore(); }}});
}

void MainWindow::show_title() {
  setWindowTitle(tr("%1[*] - wannabe").arg(document_.name()));
  setWindowFilePath(document_.path());
  setWindowModified(document_.is_modified());
}

void MainWindow::show_status(const QString& message) { status_->show_status(message); }

void MainWindow::fail(const QString& message) {
  notice_->show_notice(NoticeBar::Kind::Error, message.trimmed());
}

void MainWindow::fail_file(const QString& message) {
  std::vector<NoticeBar::Choice> choices;
  if (messages_->error_count() > 0) {
    choices.push_back({tr("Messages"), tr("List all errors and warnings, each with its line"),
                       [this] { Docks::show(message_dock_); }});
  }
  notice_->show_notice(NoticeBar::Kind::Error, message.trimmed(), choices);
}

void MainWindow::open(const QStringList& files) { files_->open(files); }

void MainWindow::offer_lost_work() { recovery_->offer_lost_work(); }

// Qt creates the tab bars of docks on demand. Each dock has its shortcut, so the bars take no focus, which
// Tab could not leave.
void MainWindow::childEvent(QChildEvent* event) {
  QMainWindow::childEvent(event);
  auto* bar = event->added() || event->polished() ? qobject_cast<QTabBar*>(event->child()) : nullptr;
  if (bar == nullptr) return;
  bar->setFocusPolicy(Qt::NoFocus);
  bar->setAccessibleName(tr("Tabbed docks"));
}

void MainWindow::closeEvent(QCloseEvent* event) {
  event->ignore();
  const auto at_once = std::make_shared<QCloseEvent*>(event);
  files_->leave([this, at_once] {
    if (*at_once == nullptr) {  // a file had to be written first
      close();
      return;
    }
    if (!may_end_work()) return;
    QSettings settings;
    docks_.save(settings);
    (*at_once)->accept();
  });
  *at_once = nullptr;
}

/// A cancelled render keeps its image so far, a bake keeps nothing, and queued jobs are not started.
bool MainWindow::may_end_work() {
  const bool renders = render_->final_render().is_running();
  if (!renders && !bake_->is_running()) return true;
  QMessageBox question(QMessageBox::Warning, tr("Close"),
                       renders ? tr("A render is running.") : tr("Irradiance is being baked."),
                       QMessageBox::Close | QMessageBox::Cancel, this);
  QString what = renders ? tr("Closing stops it and keeps the image so far.") : tr("Closing cancels it.");
  if (const int more = static_cast<int>(jobs_.jobs().size()) - 1; more > 0) {
    what += ' ' + tr("%n other job(s) are cancelled.", nullptr, more);
  }
  question.setInformativeText(what);
  question.setDefaultButton(QMessageBox::Cancel);
  question.button(QMessageBox::Cancel)->setText(tr("Continue"));
  return question.exec() == QMessageBox::Close;
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

/// Opens the first file and appends the others; with Shift appends all. Ctrl shows the import options, also
/// if they are hidden for the type.
void MainWindow::dropEvent(QDropEvent* event) {
  const QStringList dropped = local_files(*event->mimeData());
  event->acceptProposedAction();
  const auto asks =
      event->modifiers().testFlag(Qt::ControlModifier) ? AskOptions::Always : AskOptions::UnlessHidden;
  // The program from which they are dragged waits until this returns, and a dialog would block it.
  QTimer::singleShot(0, this,
                     [this, dropped, asks, appends = event->modifiers().testFlag(Qt::ShiftModifier)] {
                       appends ? files_->merge(dropped, asks) : files_->open(dropped, asks);
                     });
}

}  // namespace editor
