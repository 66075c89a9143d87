#include "editor/tools/brdf_renderer.h"

#include <QElapsedTimer>
#include <QOpenGLContext>
#include <QOpenGLVersionFunctionsFactory>
#include <bit>
#include <utility>

#include "editor/tools/brdf_drawing.h"

namespace editor {
namespace {

constexpr qint64 SliceTime = 30;  // milliseconds for which a new request waits for refinement

}  // namespace

BrdfRenderer::BrdfRenderer(const GraphicsDriver& driver, QObject* parent)
    : QObject(parent), driver_(driver), thread_("brdf viewer", [this] { drawing_.reset(); }) {}

BrdfRenderer::~BrdfRenderer() { is_end_ = true; }

int BrdfRenderer::show(const BrdfScene& scene) {
  const int number = ++latest_;
  thread_.run([this, scene, number](QOpenGLContext* context) { show_in_thread(scene, number, context); });
  return number;
}

void BrdfRenderer::probe(const QPoint& pixel) {
  thread_.run([this, pixel, number = ++latest_probe_](QOpenGLContext*) {
    if (is_end_ || number != latest_probe_ || !drawing_ || shown_ == 0) return;
    const PixelProbe probe = drawing_->probe(pixel);
    QMetaObject::invokeMethod(
        this, [this, probe] { emit probed(probe); }, Qt::QueuedConnection);
  });
}

void BrdfRenderer::make_drawing(QOpenGLContext* context) {
  const auto fail = [this](const QString& message) {
    QMetaObject::invokeMethod(
        this, [this, message] { emit failed(message); }, Qt::QueuedConnection);
  };
  auto* gl = context != nullptr ? QOpenGLVersionFunctionsFactory::get<Gl>(context) : nullptr;
  if (gl == nullptr)
    return fail(
        tr("The BRDF viewer needs OpenGL 3.3, which this display does not support. Exported figures are "
           "shaded on the CPU."));
  gl->initializeOpenGLFunctions();
  try {
    drawing_ = std::make_unique<BrdfDrawing>(*gl, driver_);
  } catch (const ShaderCompileError& error) {
    fail(
        tr("The BRDF viewer cannot draw: the graphics driver cannot compile a shader: %1").arg(error.what()));
  }
}

void BrdfRenderer::show_in_thread(const BrdfScene& scene, int number, QOpenGLContext* context) {
  if (is_end_ || number != latest_) return;
  if (!std::exchange(was_tried_, true)) make_drawing(context);
  if (!drawing_) return;
  QElapsedTimer clock;
  clock.start();
  drawing_->show(scene);
  shown_ = number;
  tell(static_cast<double>(clock.nsecsElapsed()) * 1e-9);
  if (scene.object) thread_.run([this, number](QOpenGLContext*) { refine(number); });
}

/// Works for a slice of time, and continues behind what has been requested meanwhile.
void BrdfRenderer::refine(int number) {
  if (is_end_ || number != latest_) return;
  QElapsedTimer clock;
  clock.start();
  const int before = drawing_->passes();
  drawing_->refine([&] { return is_end_ || number != latest_ || clock.elapsed() > SliceTime; });
  const int passes = drawing_->passes();
  const bool is_done = passes == drawing_->all_passes();
  // Further passes change the image less and less.
  if (passes > before && (std::has_single_bit(static_cast<unsigned>(passes)) || is_done)) tell(0);
  if (!is_done) thread_.run([this, number](QOpenGLContext*) { refine(number); });
}

void BrdfRenderer::tell(double seconds) {
  QElapsedTimer clock;
  clock.start();
  BrdfImage image;
  image.image = drawing_->image();
  image.number = shown_;
  image.passes = drawing_->passes();
  image.all_passes = drawing_->all_passes();
  image.seconds = seconds + static_cast<double>(clock.nsecsElapsed()) * 1e-9;
  image.scale = drawing_->scale();
  image.is_by_glsl = drawing_->is_by_glsl();
  image.limitations = drawing_->limitations();
  image.sources = drawing_->sources();
  image.normals = drawing_->normals();
  QMetaObject::invokeMethod(
      this, [this, image = std::move(image)] { emit drawn(image); }, Qt::QueuedConnection);
}

}  // namespace editor
