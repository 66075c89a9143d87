#pragma once

#include <QMainWindow>
#include <memory>

#include "editor/document/file_watch.h"
#include "editor/document/scene_loader.h"

class QAction;
class QLabel;
class QStackedWidget;

namespace editor {

class NoticeBar;
class SceneView;
class SourceView;

/// A read-only scene viewer. A scene is reloaded when its file or an included one changes on disk, and the
/// camera stays.
class ViewerWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit ViewerWindow(QWidget* parent = nullptr);
  ~ViewerWindow() override;

  /// Opens a GRF scene, or a model of another format. The former scene is shown until the file is read, and
  /// if it cannot be.
  void open(const QString& file);
  /// Reloads the file that was opened last.
  void reload();
  /// Absolute path of the file that was opened last; empty for none.
  const QString& path() const { return path_; }

  SceneView& view() { return *view_; }
  NoticeBar& notice() { return *notice_; }

 signals:
  /// Emitted when the file is in the view.
  void opened(const QString& file);
  void failed(const QString& message);

 protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void lay_out();
  void make_status_line();
  void add_file_actions();
  void add_view_actions();
  void ask_for_file();
  void show_scene(const std::shared_ptr<const LoadedScene>& scene);
  void show_failure(const LoadFailure& failure);
  void show_line(const grf::SourceLocation& location);
  void show_selection();
  void show_warnings(const QStringList& warnings);

  QString path_;
  std::shared_ptr<const LoadedScene> shown_;  ///< null if there is no scene
  SceneLoader loader_;
  FileWatch watch_;
  NoticeBar* notice_;
  QStackedWidget* pages_;
  QLabel* hint_;
  SceneView* view_;
  QLabel* pointed_;  ///< what is under the pointer
  QLabel* selected_;
  QLabel* warnings_;
  QLabel* counts_;
  QAction* reload_ = nullptr;
  std::unique_ptr<SourceView> source_;  ///< a separate window
};

}  // namespace editor
