#pragma once

#include <QObject>
#include <atomic>
#include <memory>
#include <optional>

#include "editor/graphics/graphics_driver.h"
#include "editor/graphics/graphics_thread.h"
#include "editor/tools/brdf_scene.h"

namespace editor {

class BrdfDrawing;

/// Draws the BRDF viewer's images in a thread. Only the latest scene counts; while it is unchanged, its image
/// is refined.
class BrdfRenderer : public QObject {
  Q_OBJECT

 public:
  explicit BrdfRenderer(const GraphicsDriver& driver = {}, QObject* parent = nullptr);
  ~BrdfRenderer() override;

  /// Returns the number of the request.
  int show(const BrdfScene& scene);
  /// Computes the light of a pixel of the latest scene; see `probed`.
  void probe(const QPoint& pixel);

 signals:
  /// Emitted with a draft, then with refined images.
  void drawn(const editor::BrdfImage& image);
  void probed(const editor::PixelProbe& probe);
  /// Emitted once if nothing can be drawn.
  void failed(const QString& message);

 private:
  // Run in the thread.
  void make_drawing(QOpenGLContext* context);
  void show_in_thread(const BrdfScene& scene, int number, QOpenGLContext* context);
  void refine(int number);
  void tell(double seconds);

  const GraphicsDriver driver_;
  std::atomic<int> latest_ = 0;
  std::atomic<int> latest_probe_ = 0;
  std::atomic<bool> is_end_ = false;
  // Used in the thread:
  std::unique_ptr<BrdfDrawing> drawing_;  // null: nothing can be drawn
  bool was_tried_ = false;
  int shown_ = 0;  // number of the request
  GraphicsThread thread_;
};

}  // namespace editor
