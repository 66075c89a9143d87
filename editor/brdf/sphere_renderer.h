#pragma once

#include <QObject>
#include <QOffscreenSurface>
#include <QThread>

#include "editor/brdf/sphere_shading.h"

namespace editor {

/// Shades spheres in a thread of its own, by GLSL where that is possible, and else by C++. Of several
/// requests only the latest counts.
class SphereRenderer : public QObject {
  Q_OBJECT

 public:
  enum class Way { Best, CppAlone };

  explicit SphereRenderer(Way way = Way::Best, QObject* parent = nullptr);
  ~SphereRenderer() override;

  void request(const SphereScene& scene);
  void stop();
  bool is_busy() const { return is_busy_; }

 signals:
  /// A first picture with few samples, then the final one.
  void shaded(const editor::SphereImage& image, bool is_final);

 private:
  class Worker;

  QOffscreenSurface surface_;
  QThread thread_;
  Worker* worker_;
  StopFlag stop_;
  int number_ = 0;  // of the latest request
  bool is_busy_ = false;
};

}  // namespace editor
