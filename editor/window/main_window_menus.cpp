// The menus of the main window, which contain every action.
#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QMenuBar>
#include <QStatusBar>
#include <QToolButton>

#include "editor/appearance/icons.h"
#include "editor/controls/actions.h"
#include "editor/controls/form_widgets.h"
#include "editor/controls/notice_bar.h"
#include "editor/image/image_browser.h"
#include "editor/panels/camera_panel.h"
#include "editor/panels/light_panel.h"
#include "editor/panels/object_panel.h"
#include "editor/panels/scene_tree.h"
#include "editor/panels/uv_panel.h"
#include "editor/rendering/cost_page.h"
#include "editor/rendering/render_panel.h"
#include "editor/tools/tool_window.h"
#include "editor/view/scene_view.h"
#include "editor/window/bake_controller.h"
#include "editor/window/brdf_controller.h"
#include "editor/window/effects_controller.h"
#include "editor/window/file_actions.h"
#include "editor/window/main_window.h"
#include "editor/window/material_actions.h"
#include "editor/window/mesh_actions.h"
#include "editor/window/object_actions.h"
#include "editor/window/pages.h"
#include "editor/window/preferences_dialog.h"
#include "editor/window/recovery_controller.h"
#include "editor/window/render_controller.h"
#include "editor/window/rendered_mode.h"
#include "editor/window/risk_dialog.h"
#include "editor/window/selection_actions.h"
#include "editor/window/shortcut_list.h"
#include "editor/window/tools.h"
#include "editor/window/view_actions.h"
#include "editor/window/view_controller.h"
#include "editor/window/visibility_actions.h"
#include "editor/window/welcome_controller.h"

namespace editor {
namespace {

QMenu* add_menu(QMenuBar& bar, const QString& title) {
  QMenu* menu = bar.addMenu(title);
  menu->setToolTipsVisible(true);
  return menu;
}

/// Shows the name of the next command in the menu entry.
QAction* name_command(QAction* action, const QString& tip) {
  action->setToolTip(tip);
  action->setStatusTip(tip);
  return action;
}

}  // namespace

void MainWindow::make_menus() {
  make_file_menu();
  make_edit_menu();
  QMenu* select = add_menu(*menuBar(), tr("&Select"));
  selection_actions_->fill(*select);
  select->addSeparator();
  visibility_actions_->fill(*select);
  QMenu* view = add_menu(*menuBar(), tr("&View"));
  view_actions_->fill(*view);
  view->addSeparator();
  render_controller_->fill(*view);
  object_actions_->fill(*add_menu(*menuBar(), tr("Ob&ject")));
  make_scene_menu();
  QMenu* render = add_menu(*menuBar(), tr("&Render"));
  render->addActions({render_->preview_action(), render_->render_action(), render_->cameras_action(),
                      render_->effects_action(), render_->animation_action(), render_->stop_action()});
  render->addSeparator();
  render->addActions({effects_->action(), render_->compare_action()});
  render->addSeparator();
  rendered_mode_->fill(*render);
  render->addSeparator();
  render->addAction(render_->noise_action());
  render->addSeparator();
  render->addAction(render_->options_action());
  image_menu_ = add_menu(*menuBar(), tr("&Image"));
  make_window_menu();
  make_help_menu();
}

void MainWindow::make_file_menu() {
  QMenu* menu = add_menu(*menuBar(), tr("&File"));
  files_->fill(*menu);
  menu->addSeparator();
  QAction* quit = new_action(*this, {tr("&Quit"), {}, QKeySequence("Ctrl+Q"), tr("Close the window")},
                             [this] { close(); });
  quit->setMenuRole(QAction::QuitRole);
  menu->addAction(quit);
}

void MainWindow::make_edit_menu() {
  QMenu* menu = add_menu(*menuBar(), tr("&Edit"));
  QUndoStack& stack = document_.undo_stack();
  QAction* undo = name_command(stack.createUndoAction(this, tr("&Undo")), tr("Undo the last change"));
  undo->setShortcut(QKeySequence::Undo);
  undo->setIcon(icon("undo"));
  QAction* redo = name_command(stack.createRedoAction(this, tr("&Redo")), tr("Redo the last undone change"));
  redo->setShortcuts({QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")});
  redo->setIcon(icon("redo"));
  addActions({undo, redo});
  menu->addActions({undo, redo});
  menu->addSeparator();
  menu->addAction(new_action(
      *this,
      {tr("&Find action"), "search", QKeySequence("F3"), tr("Search all actions by name, and run one")},
      [this] { show_shortcuts(*this); }));
  menu->addSeparator();
  menu->addActions(material_actions_->actions());
  menu->addSeparator();
  menu->addAction(mesh_actions_->delete_faces());
  menu->addSeparator();
  QAction* preferences = new_action(*this,
                                    {tr("Pr&eferences"), "options", QKeySequence("Ctrl+,"),
                                     tr("Language, theme, units, shortcuts, undo, threads, autosave")},
                                    [this] { show_preferences(); });
  preferences->setMenuRole(QAction::PreferencesRole);
  menu->addAction(preferences);
}

void MainWindow::show_preferences() {
  auto* dialog = findChild<PreferencesDialog*>();
  if (dialog == nullptr) {
    dialog = new PreferencesDialog(*keys_, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &PreferencesDialog::changed, this, &MainWindow::apply_preferences);
  }
  dialog->show();
  dialog->activateWindow();
}

/// The language applies from the next start, the up axis when a model is imported, and the dialog applies the
/// theme, which may be another one for a session.
void MainWindow::apply_preferences(const Preferences& preferences) {
  object_->show_lengths_in(preferences.length_unit);
  for (const QWidget* dock : std::initializer_list<QWidget*>{lights_, cameras_})
    show_lengths_in(preferences.length_unit, *dock);
  document_.undo_stack().set_limit(preferences.undo_steps);
  render_->set_threads(preferences.threads);
  render_->set_farm(preferences.farm);
  recovery_->set_autosave_delay(1000 * preferences.autosave_seconds);
}

void MainWindow::make_scene_menu() {
  QMenu* menu = add_menu(*menuBar(), tr("S&cene"));
  menu->addAction(new_action(*this,
                             {tr("Add a &light"), "light", QKeySequence("Ctrl+Alt+A"),
                              tr("Add a square area light above the scene, facing down")},
                             [this] { lights_->add(); }));
  menu->addAction(new_action(
      *this, {tr("Add an &observer"), "observer", {}, tr("Add an observer at the viewpoint of the 3D view")},
      [this] { view_controller_->add_observer(); }));
  menu->addActions(object_actions_->additions());
  menu->addSeparator();
  menu->addActions(mesh_actions_->of_meshes());
  QMenu* coordinates = menu->addMenu(tr("Te&xture coordinates"));
  coordinates->setToolTipsVisible(true);
  coordinates->addActions(mesh_actions_->of_texture_coordinates());
  uv_->set_menu(coordinates);
  menu->addSeparator();
  menu->addAction(
      new_action(*this,
                 {tr("C&heck..."),
                  {},
                  QKeySequence("Ctrl+Alt+V"),
                  tr("List what can make the image wrong or noisy, and repair it: lamps in solids, "
                     "flipped normals, duplicates, values that are not finite")},
                 [this] { show_risks(); }));
  menu->addAction(new_action(*this,
                             {tr("Ba&ke irradiance"), "bake", QKeySequence("Ctrl+Alt+B"),
                              tr("Bake the irradiance at all vertices and store it in the scene")},
                             [this] { bake_->bake(); }));
}

void MainWindow::show_risks() {
  auto* dialog = findChild<RiskDialog*>();
  if (dialog == nullptr) {
    dialog = new RiskDialog(document_, *mesh_actions_, catalogue_, this);
    connect(dialog, &RiskDialog::chosen, tree_, [this](const grf::ScenePath& path) { tree_->choose(path); });
  }
  dialog->show();
  dialog->activateWindow();
}

void MainWindow::make_window_menu() {
  QMenu* menu = add_menu(*menuBar(), tr("&Window"));
  docks_.fill(*menu);
  menu->addAction(new_action(*this, {tr("&Images"), {}, QKeySequence("Ctrl+7"), tr("Show the image view")},
                             [this] { image_browser(); }));
  menu->addAction(new_action(*this,
                             {tr("&Cost"),
                              {},
                              QKeySequence("Ctrl+Alt+8"),
                              tr("Compare sampling schemes and integrators by their error over time")},
                             [this] { cost_page(); }));
  menu->addAction(new_action(*this, {tr("3D &view"), {}, QKeySequence("Ctrl+`"), tr("Go to the 3D view")},
                             [this] { show_scene(); }));
  menu->addSeparator();
  menu->addAction(new_action(*this,
                             {tr("&Reset layout"), {}, {}, tr("Restore the default layout of the docks")},
                             [this] { docks_.reset(); }));
  // Hidden docks have a button each.
  for (QDockWidget* dock : {render_dock_, message_dock_, job_dock_}) {
    auto* button = new QToolButton(statusBar());
    button->setDefaultAction(docks_.action_of(dock));
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setAutoRaise(true);
    button->setAccessibleName(dock->windowTitle());
    statusBar()->addPermanentWidget(button);
  }
}

CostPage& MainWindow::cost_page() {
  if (cost_ == nullptr) {
    cost_ = new CostPage(
        document_, [this] { return rendered_mode_->framed_region(); }, pages_);
    connect(cost_, &CostPage::comparison_requested, this,
            [this](const QString& path, const QString& other, const QString& name) {
              image_browser().compare(path, other, name);
            });
  }
  pages_->show_page(*cost_, tr("Cost"), tr("Error over render time of schemes and integrators"));
  return *cost_;
}

void MainWindow::open_tool(const Tool& tool) {
  QWidget* window = tool.open({});
  window->setAttribute(Qt::WA_DeleteOnClose);
  window->show();
  auto* study = qobject_cast<ToolWindow*>(window);
  if (study == nullptr) return;
  study->set_apply_target(true);
  if (const auto brdf = brdf_controller_->common_brdf())
    study->set_brdf(*brdf, brdf_controller_->common_brdf_definitions());
  connect(study, &ToolWindow::applied, brdf_controller_, &BrdfController::assign);
}

void MainWindow::make_help_menu() {
  QMenu* menu = add_menu(*menuBar(), tr("&Tools"));
  for (const Tool& tool : tools()) {
    menu->addAction(new_action(*this, {tool.title, {}, {}, tool.about}, [this, tool] { open_tool(tool); }));
  }
  QMenu* help = add_menu(*menuBar(), tr("Help"));
  help->addAction(welcome_->action());
  help->addAction(new_action(
      *this, {tr("&Keyboard shortcuts"), {}, QKeySequence("F1"), tr("List and search all shortcuts")},
      [this] { show_shortcuts(*this); }));
  help->addAction(new_action(*this, {tr("&About wannabe"), {}, {}, tr("Version and licence")}, [this] {
    notice_->show_notice(
        NoticeBar::Kind::Information,
        tr("wannabe %1, the scene editor of Granada. Its sources are under Apache-2.0; the program contains "
           "QCustomPlot and is under GPL-3.0. It uses Qt %2 (LGPL-3.0). All libraries with "
           "their licences: share/doc/granada-wannabe/sbom.spdx.json.")
            .arg(QApplication::applicationVersion(), qVersion()));
  }));
}

}  // namespace editor
