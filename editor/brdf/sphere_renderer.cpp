#include "editor/brdf/sphere_renderer.h"

#include <QSurfaceFormat>

namespace editor {
namespace {

constexpr int RoughSamples = 16;
constexpr int FineSamples = 128;

QSurfaceFormat core_format() {
  QSurfaceFormat format;
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  return format;
}

}  // namespace

/// Lives in the thread, with its OpenGL context.
class SphereRenderer::Worker : public QObject {
 public:
  Worker(QOffscreenSurface& surface, Way way) : surface_(surface), way_(way) {}

  template <class Report>
  void shade(const SphereScene& scene, const StopFlag& stop, const Report& report) {
    for (const int samples : {RoughSamples, FineSamples}) {
      if (stop.is_set()) return;
      const SphereImage image = picture(scene, samples, stop);
      if (!stop.is_set()) report(image, samples == FineSamples);
    }
  }

  void close() { shader_.reset(); }

 private:
  SphereImage picture(const SphereScene& scene, int samples, const StopFlag& stop) {
    if (way_ == Way::Best && !was_tried_) {
      was_tried_ = true;
      shader_ = SphereShader::create(surface_);
    }
    if (shader_) {
      if (auto image = shader_->shade(scene, samples, stop)) return *std::move(image);
    }
    return shade_by_cpp(scene, samples, stop);
  }

  QOffscreenSurface& surface_;
  Way way_;
  bool was_tried_ = false;
  std::unique_ptr<SphereShader> shader_;
};

SphereRenderer::SphereRenderer(Way way, QObject* parent)
    : QObject(parent), worker_(new Worker(surface_, way)) {
  surface_.setFormat(core_format());
  surface_.create();
  worker_->moveToThread(&thread_);
  // Emitted by the thread itself, which owns the OpenGL context.
  connect(
      &thread_, &QThread::finished, worker_, [worker = worker_] { worker->close(); }, Qt::DirectConnection);
  thread_.setObjectName("sphere");
  thread_.start(QThread::LowPriority);
}

SphereRenderer::~SphereRenderer() {
  stop();
  thread_.quit();
  thread_.wait();
  delete worker_;
}

void SphereRenderer::stop() {
  stop_.set();
  ++number_;
  is_busy_ = false;
}

void SphereRenderer::request(const SphereScene& scene) {
  stop();
  stop_ = StopFlag();
  is_busy_ = true;
  QMetaObject::invokeMethod(
      worker_,
      [this, scene, worker = worker_, stop = stop_, number = number_] {
        worker->shade(scene, stop, [&](const SphereImage& image, bool is_final) {
          QMetaObject::invokeMethod(
              this,
              [this, image, is_final, number] {
                if (number != number_) return;
                is_busy_ = !is_final;
                emit shaded(image, is_final);
              },
              Qt::QueuedConnection);
        });
      },
      Qt::QueuedConnection);
}

}  // namespace editor
