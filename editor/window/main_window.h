// MainWindow is the main window of the editor.
#pragma once

#include <QMainWindow>
#include <QStringList>
#include <memory>

#include "editor/document/document.h"
#include "editor/document/preferences.h"
#include "editor/document/recovery.h"
#include "editor/jobs/job_list.h"
#include "editor/window/docks.h"
#include "grf/catalogue.h"

class QMenu;

namespace editor {

class BakeController;
class BrdfEditor;
class CameraPanel;
class BrdfController;
class CostPage;
class EffectsController;
class EnvironmentStore;
class FileActions;
class ImageBrowser;
class ImageController;
class LightController;
class LightPanel;
class MeshActions;
class MaterialActions;
class MessagePanel;
class ObjectActions;
class ObjectPanel;
class NoticeBar;
class Pages;
class RecoveryController;
class RenderController;
class RenderPanel;
class RenderedMode;
class RiskDialog;
class SceneTree;
class SceneView;
class SelectionActions;
class StatusLine;
class SurfacePanel;
class UvPanel;
class ViewActions;
class ShortcutKeys;
class ViewController;
class VisibilityActions;
class WelcomeController;
struct Tool;

/// The 3D view of a document, its docks, and the controllers that connect them. The only modal dialogs are
/// those about files.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  /// Unsaved work is autosaved in a folder of `sessions`; see Recovery.
  explicit MainWindow(const QString& sessions = Recovery::default_folder(), QWidget* parent = nullptr);
  ~MainWindow() override;

  /// Opens the first file, and appends the others.
  void open(const QStringList& files);
  /// Offers to recover the work of an earlier session that was not closed properly.
  void offer_lost_work();

  Document& document() { return document_; }
  JobList& jobs() { return jobs_; }
  FileActions& files() { return *files_; }
  SceneView& view() { return *view_; }
  EnvironmentStore& environment() { return *environment_; }
  BrdfEditor& brdf_editor() { return *brdf_editor_; }
  SurfacePanel& surface_panel() { return *surface_; }
  UvPanel& uv_panel() { return *uv_; }
  SceneTree& scene_tree() { return *tree_; }
  RenderPanel& render_panel() { return *render_; }
  RenderController& render_controller() { return *render_controller_; }
  MessagePanel& message_panel() { return *messages_; }
  NoticeBar& notice() { return *notice_; }
  StatusLine& status_line() { return *status_; }
  Docks& docks() { return docks_; }
  /// Goes to the 3D view.
  void show_scene();
  /// The image view, which is created on first use.
  ImageBrowser& image_browser();
  /// Goes to the page Cost, which is created on first use.
  CostPage& cost_page();
  /// The page Welcome, and the lessons.
  WelcomeController& welcome() { return *welcome_; }

 protected:
  void childEvent(QChildEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  // main_window.cpp
  void lay_out();
  void make_docks();
  void make_bottom_docks();
  void connect_files();
  void connect_panels();
  void connect_environment();
  void connect_actions();
  void connect_renders();
  void show_title();
  void show_status(const QString& message);
  void fail(const QString& message);
  void fail_file(const QString& message);
  void tell_of_outside_changes(const QStringList& files);
  bool may_end_work();

  // main_window_menus.cpp
  void make_menus();
  void make_file_menu();
  void make_edit_menu();
  void make_scene_menu();
  void make_window_menu();
  void make_help_menu();
  void show_preferences();
  void show_risks();
  void apply_preferences(const Preferences& preferences);
  /// Opens a tool with the BRDF of the selected faces, which can be applied to them again.
  void open_tool(const Tool& tool);

  const grf::Catalogue catalogue_;
  Document document_;
  JobList jobs_;
  Docks docks_;
  FileActions* files_;
  SceneView* view_;
  EnvironmentStore* environment_;
  NoticeBar* notice_;
  Pages* pages_;
  StatusLine* status_;
  SceneTree* tree_ = nullptr;
  LightPanel* lights_ = nullptr;
  ObjectPanel* object_ = nullptr;
  CameraPanel* cameras_ = nullptr;
  SurfacePanel* surface_ = nullptr;
  UvPanel* uv_ = nullptr;
  BrdfEditor* brdf_editor_ = nullptr;
  RenderPanel* render_ = nullptr;
  MessagePanel* messages_ = nullptr;
  QDockWidget* object_dock_ = nullptr;
  QDockWidget* render_dock_ = nullptr;
  QDockWidget* message_dock_ = nullptr;
  QDockWidget* brdf_dock_ = nullptr;
  QDockWidget* job_dock_ = nullptr;
  RenderController* render_controller_ = nullptr;
  ViewController* view_controller_ = nullptr;
  BrdfController* brdf_controller_ = nullptr;
  ViewActions* view_actions_ = nullptr;
  RenderedMode* rendered_mode_ = nullptr;
  SelectionActions* selection_actions_ = nullptr;
  VisibilityActions* visibility_actions_ = nullptr;
  ObjectActions* object_actions_ = nullptr;
  LightController* light_controller_ = nullptr;
  MaterialActions* material_actions_ = nullptr;
  MeshActions* mesh_actions_ = nullptr;
  BakeController* bake_;
  RecoveryController* recovery_;
  ImageController* images_ = nullptr;
  CostPage* cost_ = nullptr;
  EffectsController* effects_ = nullptr;
  WelcomeController* welcome_ = nullptr;
  std::unique_ptr<ShortcutKeys> keys_;  ///< of the menus
  QMenu* image_menu_ = nullptr;         ///< shown once there are images
};

}  // namespace editor
