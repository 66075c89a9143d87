#include "editor/window/main_window.h"

#include <QChildEvent>
#include <QCloseEvent>
#include <QDockWidget>
#include <QFileInfo>
#include <QLocale>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QStatusBar>
#include <QTabBar>
#include <QTabWidget>
#include <QToolBar>
#include <QUrl>
#include <QVBoxLayout>

#include "editor/appearance/icons.h"
#include "editor/appearance/theme.h"
#include "editor/brdf/brdf_editor.h"
#include "editor/brdf/live_sphere.h"
#include "editor/controls/notice_bar.h"
#include "editor/controls/tab_order.h"
#include "editor/image/image_browser.h"
#include "editor/image/image_server.h"
#include "editor/panels/light_panel.h"
#include "editor/panels/message_panel.h"
#include "editor/panels/scene_tree.h"
#include "editor/panels/surface_panel.h"
#include "editor/programs/bundled_program.h"
#include "editor/rendering/irradiance_bake.h"
#include "editor/rendering/render_files.h"
#include "editor/rendering/render_panel.h"
#include "editor/view/scene_view.h"
#include "editor/window/brdf_link.h"
#include "editor/window/file_actions.h"
#include "editor/window/mesh_actions.h"
#include "editor/window/render_link.h"
#include "editor/window/scene_comparison.h"
#include "editor/window/selection_actions.h"
#include "editor/window/source_view.h"
#include "editor/window/status_line.h"
#include "editor/window/view_actions.h"
#include "editor/window/view_link.h"
#include "renderer/reflectance/scheme.h"

namespace editor {
namespace {

/// Names of the preview in the list of images.
const char PreviewName[] = "preview";

}  // namespace

MainWindow::MainWindow(const QString& sessions, QWidget* parent)
    : QMainWindow(parent),
      catalogue_(reflectance::catalogue()),
      recovery_(document_, sessions),
      docks_(*this),
      files_(new FileActions(document_, *this)),
      view_(new SceneView),
      notice_(new NoticeBar),
      pages_(new QTabWidget),
      status_(new StatusLine(document_, *statusBar())),
      image_server_(new ImageServer(this)),
      bake_(new IrradianceBake(bundled_program("bpt"), this)) {
  setAcceptDrops(true);
  resize(200 * Grid, 125 * Grid);
  // What was said of the scene before; whoever has to say something of this one hears of it later.
  connect(&document_, &Document::taken, notice_, &QWidget::hide);
  make_docks();
  render_link_ = new RenderLink(document_, *view_, *render_, *this);
  view_link_ = new ViewLink(document_, catalogue_, *view_, *render_link_, this);
  brdf_link_ = new BrdfLink(document_, *brdf_editor_, this);
  view_actions_ = new ViewActions(*view_, *this);
  selection_actions_ = new SelectionActions(document_, *view_, *this);
  mesh_actions_ = new MeshActions(document_, *this);
  lay_out();
  make_menus();
  connect_files();
  connect_panels();
  connect_images();
  docks_.keep_as_default();
  docks_.restore(QSettings());
  show_title();
  tell(tr("Open a scene or a model, or drop one here"));
  view_->setFocus();
}

MainWindow::~MainWindow() {
  // Widgets hear of the document until they are gone, which is before it is.
  delete takeCentralWidget();
  for (QDockWidget* dock : findChildren<QDockWidget*>()) delete dock;
}

void MainWindow::lay_out() {
  auto* scene_page = new QWidget;
  auto* column = new QVBoxLayout(scene_page);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  auto* bar = new QToolBar(tr("View"), scene_page);
  bar->setIconSize({2 * Grid + Grid / 4, 2 * Grid + Grid / 4});
  view_actions_->fill(*bar);
  bar->addSeparator();
  selection_actions_->fill(*bar);
  bar->addSeparator();
  render_link_->fill(*bar);
  bar->addSeparator();
  bar->addAction(render_->preview_action());
  bar->addAction(render_->render_action());
  column->addWidget(bar);
  column->addWidget(view_, 1);
  view_->setMinimumSize(30 * Grid, 20 * Grid);

  pages_->setDocumentMode(true);
  pages_->setFocusPolicy(Qt::NoFocus);  // it would give the focus to its bar, also where that is hidden
  pages_->tabBar()->setAutoHide(true);
  pages_->setTabsClosable(true);
  pages_->addTab(scene_page, tr("Scene"));
  pages_->setTabToolTip(0, tr("The scene in three dimensions"));
  for (const auto side : {QTabBar::LeftSide, QTabBar::RightSide})
    pages_->tabBar()->setTabButton(0, side, nullptr);
  pages_->setAccessibleName(tr("Pages"));
  pages_->tabBar()->setAccessibleName(tr("Pages"));
  pages_->tabBar()->setToolTip(tr("The scene, images, and the text of files"));
  connect(pages_, &QTabWidget::tabCloseRequested, this, [this](int page) {
    if (page > 0) pages_->removeTab(page);
  });

  auto* centre = new QWidget(this);
  auto* rows = new QVBoxLayout(centre);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(0);
  rows->addWidget(notice_);
  rows->addWidget(pages_, 1);
  setCentralWidget(centre);
}

void MainWindow::make_docks() {
  setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks);
  setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
  tree_ = new SceneTree(document_);
  lights_ = new LightPanel(document_);
  surface_ = new SurfacePanel(document_, catalogue_);
  brdf_editor_ = new BrdfEditor;
  render_ = new RenderPanel(document_);
  messages_ = new MessagePanel(document_, catalogue_);
  QDockWidget* tree =
      docks_.add({"scene", tr("Scene"), "objects", QKeySequence("Ctrl+1"), tr("All that the scene holds")},
                 Qt::LeftDockWidgetArea, tree_);
  QDockWidget* lights =
      docks_.add({"lights", tr("Lights"), "light", QKeySequence("Ctrl+2"), tr("All that emits in the scene")},
                 Qt::LeftDockWidgetArea, lights_);
  QDockWidget* surface = docks_.add(
      {"surface", tr("Surface"), "texture", QKeySequence("Ctrl+3"), tr("What the selected faces have")},
      Qt::RightDockWidgetArea, surface_);
  brdf_dock_ = docks_.add({"brdf", tr("BRDF"), "brdf", QKeySequence("Ctrl+4"),
                           tr("The BRDF of the selected faces: its parameters, shape and looks")},
                          Qt::RightDockWidgetArea, brdf_editor_);
  render_dock_ = docks_.add(
      {"render", tr("Render"), "render", QKeySequence("Ctrl+5"), tr("Previews and images of the scene")},
      Qt::BottomDockWidgetArea, render_);
  message_dock_ = docks_.add({"messages", tr("Messages"), "note", QKeySequence("Ctrl+6"),
                              tr("What is wrong with the scene and its file")},
                             Qt::BottomDockWidgetArea, messages_);
  splitDockWidget(tree, lights, Qt::Vertical);
  splitDockWidget(surface, brdf_dock_, Qt::Vertical);
  tabifyDockWidget(render_dock_, message_dock_);
  resizeDocks({tree, surface}, {34 * Grid, 46 * Grid}, Qt::Horizontal);
  resizeDocks({tree, lights}, {70 * Grid, 40 * Grid}, Qt::Vertical);
  resizeDocks({surface, brdf_dock_}, {48 * Grid, 62 * Grid}, Qt::Vertical);
  render_dock_->hide();
  message_dock_->hide();
}

void MainWindow::connect_files() {
  connect(files_, &FileActions::done, this, &MainWindow::tell);
  connect(files_, &FileActions::failed, this, &MainWindow::fail_file);
  connect(files_, &FileActions::reported, messages_, &MessagePanel::show_diagnostics);
  connect(&files_->outside_changes(), &OutsideChanges::found, this, &MainWindow::tell_of_outside_changes);
  connect(files_, &FileActions::busy, this, [this](const QString& what) {
    if (what.isEmpty()) return status_->end_work();
    status_->begin_work(what, [this] { files_->cancel_import(); });
  });
  connect(&document_, &Document::taken, this, [this] { pages_->setCurrentIndex(0); });
  connect(&document_, &Document::path_changed, this, &MainWindow::show_title);
  connect(&document_, &Document::told, this, &MainWindow::tell);
  connect(&document_, &Document::modified_changed, this, &MainWindow::show_title);
  connect(&recovery_, &Recovery::failed, this, [this](const QString& message) {
    notice_->show_notice(NoticeBar::Kind::Error,
                         tr("Unsaved work is not kept against a crash: %1").arg(message));
  });
}

void MainWindow::connect_panels() {
  connect(view_, &SceneView::hovered, status_, &StatusLine::show_hovered);
  connect(view_, &SceneView::message, this, &MainWindow::tell);
  connect(view_, &SceneView::warned, messages_, &MessagePanel::add_warning);
  connect(&brdf_editor_->sphere(), &LiveSphere::warned, messages_, &MessagePanel::add_warning);
  connect(mesh_actions_, &MeshActions::told, this, &MainWindow::tell);
  connect(mesh_actions_, &MeshActions::failed, this, &MainWindow::fail);
  connect(view_link_, &ViewLink::failed, this, &MainWindow::fail);
  connect(view_link_, &ViewLink::told, this, &MainWindow::tell);
  connect(brdf_link_, &BrdfLink::failed, this, &MainWindow::fail);
  connect(&document_, &Document::lit_by_a_plain_sky, this, [this] {
    notice_->show_notice(
        NoticeBar::Kind::Information,
        tr("Nothing in this scene emits light. Until something does, renders have a grey sky."),
        {{tr("Add a light"), tr("Puts a lamp over the scene"), [this] { lights_->add(); }}});
  });
  connect(tree_, &SceneTree::chosen, this, [this](const grf::ScenePath& path) { lights_->choose(path); });
  connect(lights_, &LightPanel::chosen, this, [this](const grf::ScenePath& path) { tree_->choose(path); });
  connect(surface_, &SurfacePanel::brdf_edit_requested, this, [this] {
    Docks::show(brdf_dock_);
    brdf_editor_->form().setFocus();
  });
  connect(surface_, &SurfacePanel::pick_requested, this,
          [this] { view_link_->pick_face([this](FaceId face) { surface_->take_from(face); }); });
  connect(surface_, &SurfacePanel::bake_requested, this, &MainWindow::bake);
  connect(messages_, &MessagePanel::place_requested, this, &MainWindow::show_source);
  connect(messages_, &MessagePanel::chosen, tree_,
          [this](const grf::ScenePath& path) { tree_->choose(path); });
  connect(messages_, &MessagePanel::messages_changed, this, [this] {
    const std::size_t errors = messages_->error_count();
    const std::size_t count = errors + messages_->warning_count();
    QAction* action = docks_.action_of(message_dock_);
    action->setText(count == 0 ? tr("Messages") : tr("Messages (%1)").arg(count));
    action->setIcon(icon(errors > 0 ? "error" : count > 0 ? "warning" : "note"));
  });
  connect(bake_, &IrradianceBake::progressed, this, [this](double done) { status_->show_done(done); });
  connect(bake_, &IrradianceBake::failed, this, [this](const QString& why) {
    status_->end_work();
    fail(why);
  });
  connect(bake_, &IrradianceBake::finished, this, &MainWindow::take_irradiance);
}

void MainWindow::connect_images() {
  if (!image_server_->listen()) image_server_->listen(0);  // another viewer has the usual port
  render_->final_render().set_display(QString("127.0.0.1:%1").arg(image_server_->port()));
  connect(image_server_, &ImageServer::received, this,
          [this](const QString& name, const std::shared_ptr<const transport::Image>& image) {
            render_->final_render().show(name, image);
            const bool is_ours = name == render_->final_render().output();
            if (!is_ours) return image_browser().show_image(name, image);
            if (pages_->indexOf(images_) >= 0) images_->show_image_of(name, image);
          });
  connect(render_, &RenderPanel::image_opened, this,
          [this](const QString& path) { image_browser().open_files({path}); });
  connect(render_, &RenderPanel::preview_opened, this, [this] {
    if (render_->preview().image()) image_browser().show_image(PreviewName, render_->preview().image());
  });
  connect(&render_->preview(), &Preview::image_changed, this, [this](const auto& image) {
    if (images_ != nullptr && images_->isVisible() && images_->names().contains(PreviewName)) {
      images_->show_image(PreviewName, image);
    }
  });
  // Whoever begins a render wants to see it.
  const auto show_render = [this] { Docks::show(render_dock_); };
  connect(render_->preview_action(), &QAction::triggered, this, show_render);
  connect(render_->render_action(), &QAction::triggered, this, show_render);
  connect(render_, &RenderPanel::op_file_differs, this, [this](const QString& path) {
    notice_->show_notice(
        NoticeBar::Kind::Information,
        tr("%1 says other things than are rendered. Saving the scene writes it, too.")
            .arg(QFileInfo(path).fileName()),
        {{tr("Write it now"), tr("Puts the present options into the file; its comments stay"), [this] {
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

ImageBrowser& MainWindow::image_browser() {
  if (images_ == nullptr) {
    images_ = new ImageBrowser(this);
    const ImageTools& tools = images_->tools();
    image_menu_->addActions({tools.open, tools.save, tools.copy});
    image_menu_->addSeparator();
    image_menu_->addActions(tools.of_view);
    image_menu_->addSeparator();
    image_menu_->addActions({tools.flip, tools.swap});
    image_menu_->menuAction()->setVisible(true);
  }
  show_page(*images_, tr("Images"), tr("Images of renders and files, to look at and to compare"));
  return *images_;
}

void MainWindow::show_page(QWidget& page, const QString& title, const QString& tip) {
  if (pages_->indexOf(&page) < 0) {
    pages_->setTabToolTip(pages_->addTab(&page, title), tip);
    lead_tab_through({pages_});
  }
  pages_->setCurrentWidget(&page);
}

void MainWindow::show_source(const grf::SourceLocation& location) {
  if (source_ == nullptr) source_ = new SourceView(this);
  show_page(*source_, tr("Source"), tr("The text of the file that a message is about"));
  source_->show(location);
}

void MainWindow::tell_of_outside_changes(const QStringList& files) {
  notice_->show_notice(
      NoticeBar::Kind::Information, tr("Another program has changed %1.").arg(files.join(", ")),
      {{tr("Reload"), tr("Reads the scene again; asks first if there are changes that are not saved"),
        [this] { files_->revert(); }},
       {tr("Compare"), tr("Shows how the scene differs from its file"),
        [this] {
          if (comparison_ == nullptr) comparison_ = new SceneComparison(this);
          show_page(*comparison_, tr("Compare"), tr("How the scene differs from its file"));
          comparison_->compare(document_.scene(), document_.path());
        }},
       {tr("Keep mine"), tr("Keeps the scene as it is here; saving replaces the file"),
        [this] { files_->outside_changes().ignore(); }}});
}

void MainWindow::show_title() {
  setWindowTitle(tr("%1[*] - wannabe").arg(document_.name()));
  setWindowFilePath(document_.path());
  setWindowModified(document_.is_modified());
}

void MainWindow::tell(const QString& message) { status_->tell(message); }

void MainWindow::fail(const QString& message) {
  notice_->show_notice(NoticeBar::Kind::Error, message.trimmed());
}

void MainWindow::fail_file(const QString& message) {
  std::vector<NoticeBar::Choice> choices;
  if (messages_->error_count() > 0) {
    choices.push_back({tr("Messages"), tr("Lists all that is wrong, each with its line"),
                       [this] { Docks::show(message_dock_); }});
  }
  notice_->show_notice(NoticeBar::Kind::Error, message.trimmed(), choices);
}

void MainWindow::bake() {
  if (bake_->is_running()) return;
  status_->begin_work(tr("Baking irradiance"), [this] { bake_->stop(); });
  options::RenderOptions bake_options = document_.options().valid_options();
  bake_options.samples.reset();  // those of a pixel say nothing of a vertex
  bake_->start(document_.scene(), document_.path(), bake_options);
}

void MainWindow::take_irradiance(const BakedIrradiance& irradiance, const IrradianceBakeResult& result) {
  status_->end_work();
  IrradiatedScene irradiated =
      irradiance.applied_to(document_.scene(), naming_path(document_.path()).toStdString());
  if (irradiated.meshes == 0) {
    return fail(tr("The irradiance that was baked is left out: no mesh of its scene is as it was"));
  }
  document_.replace(tr("Bake irradiance"), std::move(irradiated.scene));
  QStringList messages = {tr("Irradiance is at the vertices now. IGRF files keep it.")};
  if (!result.messages.isEmpty()) messages << result.messages.trimmed();
  if (irradiated.left_alone > 0) {
    messages << tr("%n mesh(es) were edited meanwhile, and keep what they had.", nullptr,
                   static_cast<int>(irradiated.left_alone));
  }
  if (irradiated.dissolved > 0) {
    messages << tr(
        "Files that are included several times get other light at each place, and are part of the "
        "scene now.");
  }
  tell(messages.join('\n'));
}

void MainWindow::open(const QStringList& files) {
  if (files.isEmpty()) return;
  files_->open(files.front());
  for (const QString& file : files.mid(1)) files_->merge(file);
}

void MainWindow::offer_lost_work() {
  if (files_->is_importing()) {  // a scene that comes takes away what is said before
    connect(files_, &FileActions::busy, this, &MainWindow::offer_lost_work, Qt::SingleShotConnection);
    return;
  }
  const std::vector<LostWork> all = recovery_.lost_work();
  if (all.empty()) return;
  const LostWork& work = all.front();
  const QString name =
      work.path.isEmpty() ? tr("a scene that was never saved") : QFileInfo(work.path).fileName();
  const QString when = QLocale().toString(work.saved, QLocale::ShortFormat);
  notice_->show_notice(
      NoticeBar::Kind::Information,
      tr("The last session ended unexpectedly. Unsaved work on %1 was kept at %2.").arg(name, when),
      {{tr("Recover"), tr("Opens it as it was"), [this, work] { recover(work); }},
       {tr("Discard"), tr("Deletes what was kept, without a way back"), [this, work] {
          Recovery::discard(work);
          offer_lost_work();
        }}});
}

void MainWindow::recover(const LostWork& work) {
  files_->leave([this, work] {
    grf::Diagnostics diagnostics;
    auto scene = Recovery::read(work, diagnostics);
    if (!scene) return fail(QString::fromStdString(diagnostics.to_text()));
    document_.take(std::move(*scene), work.path, diagnostics, true);
    // The other is gone only once this session has it.
    connect(
        &recovery_, &Recovery::kept, this, [work] { Recovery::discard(work); }, Qt::SingleShotConnection);
    recovery_.keep();
    tell(tr("Recovered: save it to keep it"));
  });
}

// Qt makes the bars of docks that share a place when it needs them. Each dock has its key, so they take no
// focus, out of which Tab would not lead.
void MainWindow::childEvent(QChildEvent* event) {
  QMainWindow::childEvent(event);
  auto* bar = event->added() || event->polished() ? qobject_cast<QTabBar*>(event->child()) : nullptr;
  if (bar == nullptr) return;
  bar->setFocusPolicy(Qt::NoFocus);
  bar->setAccessibleName(tr("Docks at one place"));
}

void MainWindow::closeEvent(QCloseEvent* event) {
  event->ignore();
  if (!may_end_work()) return;
  files_->leave([this, event] {
    QSettings settings;
    docks_.save(settings);
    event->accept();
  });
}

/// A render that is ended keeps the image so far, a bake keeps nothing.
bool MainWindow::may_end_work() {
  const bool renders = render_->final_render().is_running();
  if (!renders && !bake_->is_running()) return true;
  QMessageBox question(QMessageBox::Warning, tr("Close"),
                       renders ? tr("A render is running.") : tr("Irradiance is being baked."),
                       QMessageBox::Close | QMessageBox::Cancel, this);
  question.setInformativeText(renders ? tr("Closing stops it, and keeps the image so far.")
                                      : tr("Closing gives it up."));
  question.setDefaultButton(QMessageBox::Cancel);
  question.button(QMessageBox::Cancel)->setText(tr("Go on"));
  return question.exec() == QMessageBox::Close;
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

/// The first file is opened and the others are merged in; with Shift all are.
void MainWindow::dropEvent(QDropEvent* event) {
  QStringList dropped;
  for (const QUrl& url : event->mimeData()->urls()) {
    if (url.isLocalFile()) dropped.append(url.toLocalFile());
  }
  event->acceptProposedAction();
  if (!event->modifiers().testFlag(Qt::ShiftModifier)) return open(dropped);
  for (const QString& file : dropped) files_->merge(file);
}

}  // namespace editor
