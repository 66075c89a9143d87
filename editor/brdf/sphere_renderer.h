#pragma once

#include <QObject>
#include <memory>

#include "editor/brdf/sphere_shading.h"
#include "editor/graphics/graphics_thread.h"

namespace editor {

/// Shades spheres in a thread, with GLSL where possible, else on the CPU. Only the latest request counts.
class SphereRenderer : public QObject {
  Q_OBJECT

 public:
  explicit SphereRenderer(const GraphicsDriver& driver = {}, QObject* parent = nullptr);
  ~SphereRenderer() override;

  void request(const SphereScene& scene);
  void stop();
  bool is_busy() const { return is_busy_; }

 signals:
  /// Emitted with a noisy image of few samples, then with the final one.
  void shaded(const editor::SphereImage& image, bool is_final);
  /// Emitted when the graphics driver cannot compile the BRDF's shader, so that the CPU shades it.
  void warned(const QString& message);

 private:
  SphereImage picture(const SphereScene& scene, int samples, const StopFlag& stop, QOpenGLContext* context);
  void warn_of_compile_error();
  void report(const SphereImage& image, bool is_final, int number);

  const GraphicsDriver driver_;
  StopFlag stop_;
  int number_ = 0;  // of the latest request
  bool is_busy_ = false;
  std::unique_ptr<SphereShader> shader_;  // of the thread
  bool was_tried_ = false;
  GraphicsThread thread_;
};

}  // namespace editor
