#include "editor/view/view_renderer.h"

#include <QOpenGLContext>
#include <QOpenGLVersionFunctionsFactory>
#include <QTransform>
#include <chrono>
#include <utility>

#include "editor/view/region_selection.h"
#include "editor/view/view_drawing.h"

namespace editor {
namespace {

/// The time for which the view has to rest before a slow image is started.
constexpr std::chrono::milliseconds RestTime{50};

}  // namespace

ViewRenderer::ViewRenderer(const GraphicsDriver& driver, QObject* parent)
    : QObject(parent), driver_(driver), thread_("view", [this] { drawing_.reset(); }) {}

ViewRenderer::~ViewRenderer() {
  {
    const std::lock_guard lock(mutex_);
    requests_.is_end = true;
  }
  requested_.notify_one();
}

void ViewRenderer::show(const ViewState& state) {
  request([&state](Requests& requests) { requests.state = state; });
}

void ViewRenderer::select(const ViewRegion& region) {
  request([&region](Requests& requests) {
    requests.region = region;
    requests.state.reset();  // the region's state is newer
  });
}

void ViewRenderer::request(const std::function<void(Requests&)>& change) {
  {
    const std::lock_guard lock(mutex_);
    change(requests_);
  }
  requested_.notify_one();
  if (std::exchange(is_running_, true)) return;
  thread_.run([this](QOpenGLContext* context) { run(context); });
}

void ViewRenderer::make_drawing(QOpenGLContext* context) {
  auto* gl = context != nullptr ? QOpenGLVersionFunctionsFactory::get<Gl>(context) : nullptr;
  if (gl == nullptr) return warn(tr("The 3D view needs OpenGL 3.3, which this display does not support."));
  gl->initializeOpenGLFunctions();
  try {
    drawing_ = std::make_unique<ViewDrawing>(*gl, driver_);
  } catch (const ShaderCompileError& error) {
    warn(tr("The 3D view cannot draw: the graphics driver cannot compile a shader: %1").arg(error.what()));
  }
}

void ViewRenderer::run(QOpenGLContext* context) {
  make_drawing(context);
  for (;;) {
    const Requests requests = next_requests();
    if (requests.is_end) return;
    if (requests.region) select_in_thread(*requests.region);
    if (drawing_ == nullptr) continue;
    if (requests.state) show_in_thread(*requests.state);
    if (requests.empty() && drawing_->work([this] { return has_requests(); })) tell_image();
  }
}

/// Waits for requests, unless the image can be refined.
ViewRenderer::Requests ViewRenderer::next_requests() {
  std::unique_lock lock(mutex_);
  const auto are_there = [this] { return !requests_.empty(); };
  const bool has_picture = drawing_ != nullptr && drawing_->state().objects != nullptr;
  if (!has_picture || drawing_->is_done()) {
    requested_.wait(lock, are_there);
  } else if (drawing_->is_slow() && !drawing_->is_full()) {
    // While a heavy scene is orbited, all time is spent on drafts.
    requested_.wait_for(lock, RestTime, are_there);
  }
  return std::exchange(requests_, {});
}

bool ViewRenderer::has_requests() {
  const std::lock_guard lock(mutex_);
  return !requests_.empty();
}

void ViewRenderer::show_in_thread(const ViewState& state) {
  const ViewState& before = drawing_->state();
  if (state.objects != before.objects || state.request.style.mode != before.request.style.mode) told_.clear();
  asked_size_ = state.size;
  drawing_->show(state);
  tell_image();
}

void ViewRenderer::tell_shortcomings() {
  for (const QString& text : drawing_->limitations()) {
    if (told_.contains(text)) continue;
    told_ += text;
    warn(text);
  }
}

void ViewRenderer::warn(const QString& text) {
  QMetaObject::invokeMethod(
      this, [this, text] { emit warned(text); }, Qt::QueuedConnection);
}

void ViewRenderer::select_in_thread(const ViewRegion& region) {
  // Without an image nothing is occluded.
  const bool selects_through = region.selects_through || drawing_ == nullptr;
  if (drawing_ != nullptr) show_in_thread(region.state);
  const ViewState& state = drawing_ != nullptr ? drawing_->state() : region.state;
  const ProjectedScene projected{*state.objects, state.shapes, state.request.camera, state.size};
  const double ratio = state.screen.pixel_ratio;
  const QPainterPath path = QTransform::fromScale(ratio, ratio).map(region.path);
  const FaceSelection selection = selects_through
                                      ? all_in_region(projected, path)
                                      : visible_in_region(projected, path, [this](const QRect& rectangle) {
                                          return drawing_->faces_in(rectangle);
                                        });
  QMetaObject::invokeMethod(
      this, [this, selection, number = state.number] { emit selected(selection, number); },
      Qt::QueuedConnection);
}

void ViewRenderer::tell_image() {
  const ViewImage image = {drawing_->image(), asked_size_, drawing_->state().number, drawing_->is_full(),
                           drawing_->is_done()};
  tell_shortcomings();
  QMetaObject::invokeMethod(
      this, [this, image] { emit drawn(image); }, Qt::QueuedConnection);
}

}  // namespace editor
