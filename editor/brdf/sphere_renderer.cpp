#include "editor/brdf/sphere_renderer.h"

#include <utility>

namespace editor {
namespace {

constexpr int RoughSamples = 16;
constexpr int FineSamples = 128;

}  // namespace

SphereRenderer::SphereRenderer(const GraphicsDriver& driver, QObject* parent)
    : QObject(parent), driver_(driver), thread_("sphere", [this] { shader_.reset(); }) {}

SphereRenderer::~SphereRenderer() { stop(); }

void SphereRenderer::stop() {
  stop_.set();
  ++number_;
  is_busy_ = false;
}

void SphereRenderer::request(const SphereScene& scene) {
  stop();
  stop_ = StopFlag();
  is_busy_ = true;
  thread_.run([this, scene, stop = stop_, number = number_](QOpenGLContext* context) {
    for (const int samples : {RoughSamples, FineSamples}) {
      if (stop.is_set()) return;
      const SphereImage image = picture(scene, samples, stop, context);
      if (!stop.is_set()) report(image, samples == FineSamples, number);
    }
  });
}

SphereImage SphereRenderer::picture(const SphereScene& scene, int samples, const StopFlag& stop,
                                    QOpenGLContext* context) {
  if (!std::exchange(was_tried_, true) && context != nullptr) {
    shader_ = SphereShader::create(*context, driver_);
  }
  if (shader_) {
    if (auto image = shader_->shade(scene, samples, stop)) return *std::move(image);
    if (!shader_->compile_error().isEmpty()) warn_of_compile_error();
  }
  return shade_on_cpu(scene, samples, stop);
}

void SphereRenderer::warn_of_compile_error() {
  QMetaObject::invokeMethod(
      this,
      [this, why = shader_->compile_error()] {
        emit warned(
            tr("The graphics driver cannot compile the shader of a BRDF: its sphere is shaded on the CPU: %1")
                .arg(why));
      },
      Qt::QueuedConnection);
}

void SphereRenderer::report(const SphereImage& image, bool is_final, int number) {
  QMetaObject::invokeMethod(
      this,
      [this, image, is_final, number] {
        if (number != number_) return;
        is_busy_ = !is_final;
        emit shaded(image, is_final);
      },
      Qt::QueuedConnection);
}

}  // namespace editor
