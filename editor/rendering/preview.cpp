#include "editor/rendering/preview.h"

#include <utility>

namespace editor {

using job::PreviewState;

namespace {

/// Time limit for the first image of an outdated request, after which it is abandoned.
constexpr std::chrono::milliseconds AbandonDelay(400);

}  // namespace

Preview::Preview(QObject* parent, const ImageProcess& images)
    : QObject(parent),
      render_(listener(), [images](const std::string& path, grf::Diagnostics& diagnostics,
                                   const grf::SourceLocation& asked_for_at, image::Alpha alpha,
                                   const std::stop_token& stop) {
        return images.read(path, diagnostics, asked_for_at, stop, alpha);
      }) {
  abandon_timer_.setSingleShot(true);
  abandon_timer_.setInterval(AbandonDelay);
  connect(&abandon_timer_, &QTimer::timeout, this, &Preview::start_waiting);
}

// Callbacks from the render thread, which pass results to this object's thread.
job::PreviewListener Preview::listener() {
  job::PreviewListener listener;
  listener.image = [this](int request, auto image, const transport::RenderProgress& progress) {
    const std::lock_guard lock(pending_.lock);
    const bool is_posted = pending_.image != nullptr;
    pending_.request = request;
    pending_.image = std::move(image);
    pending_.progress = progress;
    if (!is_posted) QMetaObject::invokeMethod(this, &Preview::take_image, Qt::QueuedConnection);
  };
  // Its image follows.
  listener.accuracy = [this](int request, auto accuracy) {
    const std::lock_guard lock(pending_.lock);
    pending_.accuracy = std::move(accuracy);
    pending_.accuracy_request = request;
  };
  listener.diagnostics = [this](int request, const grf::Diagnostics& diagnostics) {
    QMetaObject::invokeMethod(
        this,
        [this, request, diagnostics] {
          if (request == request_) emit diagnosed(diagnostics);
        },
        Qt::QueuedConnection);
  };
  listener.state = [this](int request, PreviewState state) {
    QMetaObject::invokeMethod(
        this, [this, request, state] { take_state(request, state); }, Qt::QueuedConnection);
  };
  return listener;
}

void Preview::restart(job::PreviewRequest request) {
  if (is_on_ && !has_shown_ && state_ == PreviewState::Preparing) {
    waiting_ = std::move(request);
    if (!abandon_timer_.isActive()) abandon_timer_.start();
    return;
  }
  start(std::move(request));
}

void Preview::start(job::PreviewRequest request) {
  waiting_.reset();
  abandon_timer_.stop();
  is_on_ = true;
  has_shown_ = false;
  accuracy_.reset();
  state_ = PreviewState::Preparing;
  region_ = request.region;
  request_ = render_.start(std::move(request));
  emit state_changed(state_);
}

void Preview::start_waiting() {
  if (waiting_) start(*std::exchange(waiting_, std::nullopt));
}

void Preview::stop() {
  if (!is_on_) return;
  waiting_.reset();
  abandon_timer_.stop();
  render_.stop();
  is_on_ = false;
  request_ = 0;
  emit stopped();
}

void Preview::pause() {
  if (is_on_) render_.pause();
}

void Preview::resume() { render_.resume(); }

void Preview::take_image() {
  int request = 0;
  std::shared_ptr<const image::Image> image;
  transport::RenderProgress progress;
  std::shared_ptr<const job::PreviewAccuracy> accuracy;
  int accuracy_request = 0;
  {
    const std::lock_guard lock(pending_.lock);
    request = pending_.request;
    image = std::exchange(pending_.image, nullptr);
    progress = pending_.progress;
    accuracy = std::exchange(pending_.accuracy, nullptr);
    accuracy_request = pending_.accuracy_request;
  }
  if (!is_on_ || request != request_) return;
  if (accuracy && accuracy_request == request) accuracy_ = std::move(accuracy);
  image_ = std::move(image);
  image_region_ = region_;
  has_shown_ = true;
  if (state_ == PreviewState::Preparing) emit state_changed(state_ = PreviewState::Rendering);
  emit image_changed(image_, progress);
  start_waiting();
}

void Preview::take_state(int request, PreviewState state) {
  if (!is_on_ || request != request_ || state == state_) return;
  // Until its first image a request counts as being prepared.
  if (state == PreviewState::Rendering && !has_shown_) return;
  state_ = state;
  if (state == PreviewState::Failed) is_on_ = false;
  emit state_changed(state);
  if (state == PreviewState::Failed) start_waiting();
}

}  // namespace editor
