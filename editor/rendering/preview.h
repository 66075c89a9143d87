#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <mutex>
#include <optional>

#include "editor/programs/image_process.h"
#include "renderer/job/preview_render.h"

namespace editor {

/// A scene's image while one goes on editing: begins coarse, refines, and begins anew with each edit. Renders
/// in threads of its own; images are read in processes of their own.
class Preview : public QObject {
  Q_OBJECT

 public:
  explicit Preview(QObject* parent = nullptr, const ImageProcess& images = ImageProcess());

  /// Shows this from now on. While edits follow each other faster than images come, each image is of the
  /// newest edit that there was when it was begun.
  void restart(job::PreviewRequest request);
  /// Leaves the last image as it is.
  void stop();
  void pause();
  void resume();

  /// Between `restart` and `stop`, or a failure; finished and paused previews too.
  bool is_on() const { return is_on_; }
  bool is_paused() const { return is_on_ && state_ == job::PreviewState::Paused; }
  /// The last image; null: none yet.
  const std::shared_ptr<const transport::Image>& image() const { return image_; }

 signals:
  /// An image, at first smaller than asked for. Never more often than the window takes them.
  void image_changed(std::shared_ptr<const transport::Image> image, transport::RenderProgress progress);
  void state_changed(job::PreviewState state);
  void stopped();
  /// What is wrong with the scene or the options; empty diagnostics: nothing is any more.
  void diagnosed(grf::Diagnostics diagnostics);

 private:
  /// What the thread has said and the window has not heard.
  struct Mail {
    std::mutex lock;
    int request = 0;
    std::shared_ptr<const transport::Image> image;
    transport::RenderProgress progress;
  };

  job::PreviewListener listener();
  void start(job::PreviewRequest request);
  void take_image();
  void take_state(int request, job::PreviewState state);
  void start_waiting();

  int request_ = 0;
  bool is_on_ = false;
  bool has_shown_ = false;  ///< the current request
  job::PreviewState state_ = job::PreviewState::Done;
  std::shared_ptr<const transport::Image> image_;
  std::optional<job::PreviewRequest> waiting_;
  QTimer patience_;
  Mail mail_;
  job::PreviewRender render_;  ///< the last member: its thread calls this
};

}  // namespace editor
