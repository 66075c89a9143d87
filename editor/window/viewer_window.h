#pragma once

#include <QMainWindow>
#include <memory>

#include "editor/window/file_watch.h"
#include "editor/window/scene_loader.h"

class QAction;
class QLabel;
class QStackedWidget;

namespace editor {

class NoticeBar;
class SceneView;
class SourceView;

/// A window that shows scenes and changes nothing. A file that changes on disk, or one that it includes, is
/// shown anew from where it was looked at.
class ViewerWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit ViewerWindow(QWidget* parent = nullptr);
  ~ViewerWindow() override;

  /// A GRF scene, or a model of another format. What was shown before stays until the file was read, and if
  /// it cannot be.
  void open(const QString& file);
  /// Reads the file that was opened last once more.
  void reload();
  /// Absolute, of the file that was opened last; empty: none was.
  const QString& path() const { return path_; }

  SceneView& view() { return *view_; }
  NoticeBar& notice() { return *notice_; }

 signals:
  /// The file is in the view.
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
  std::shared_ptr<const LoadedScene> shown_;  ///< null: there is no scene
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
  std::unique_ptr<SourceView> source_;  ///< a window of its own
};

}  // namespace editor
