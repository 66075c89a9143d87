#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <mutex>
#include <optional>

#include "editor/programs/image_process.h"
#include "renderer/job/preview_render.h"

namespace editor {

/// A progressive preview of a scene that is being edited: starts coarse, refines, and restarts with each
/// edit. Renders in threads; textures are decoded in child processes.
class Preview : public QObject {
  Q_OBJECT

 public:
  explicit Preview(QObject* parent = nullptr, const ImageProcess& images = ImageProcess());

  /// Renders a new request. While edits arrive faster than images, each image shows the newest edit at the
  /// time when it was started.
  void restart(job::PreviewRequest request);
  /// Stops, and keeps the last image.
  void stop();
  void pause();
  void resume();

  /// True between `restart` and `stop` or a failure; also for finished and paused previews.
  bool is_on() const { return is_on_; }
  bool is_paused() const { return is_on_ && state_ == job::PreviewState::Paused; }
  /// The last image; null before the first.
  const std::shared_ptr<const image::Image>& image() const { return image_; }
  /// The last accuracy that was measured of the current request; null before the first.
  const std::shared_ptr<const job::PreviewAccuracy>& accuracy() const { return accuracy_; }
  /// The region that the last image is limited to; empty: none.
  const std::optional<job::PreviewRegion>& region() const { return image_region_; }

 signals:
  /// Emitted with an image, at first smaller than requested, and never faster than the window handles them.
  void image_changed(std::shared_ptr<const image::Image> image, transport::RenderProgress progress);
  void state_changed(job::PreviewState state);
  void stopped();
  /// Emitted with the diagnostics of scene and options; empty when all errors are resolved.
  void diagnosed(grf::Diagnostics diagnostics);

 private:
  /// Results of the thread that the window has not received yet.
  struct PendingResults {
    std::mutex lock;
    int request = 0;
    std::shared_ptr<const image::Image> image;
    std::shared_ptr<const job::PreviewAccuracy> accuracy;  ///< null: no new one
    int accuracy_request = 0;
    transport::RenderProgress progress;
  };

  job::PreviewListener listener();
  void start(job::PreviewRequest request);
  void take_image();
  void take_state(int request, job::PreviewState state);
  void start_waiting();

  int request_ = 0;
  bool is_on_ = false;
  bool has_shown_ = false;  ///< an image of the current request
  job::PreviewState state_ = job::PreviewState::Done;
  std::shared_ptr<const image::Image> image_;
  std::shared_ptr<const job::PreviewAccuracy> accuracy_;
  std::optional<job::PreviewRegion> region_;  ///< of the current request
  std::optional<job::PreviewRegion> image_region_;
  std::optional<job::PreviewRequest> waiting_;
  QTimer abandon_timer_;
  PendingResults pending_;
  job::PreviewRender render_;  ///< the last member: its thread calls this
};

}  // namespace editor
