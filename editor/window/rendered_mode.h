#pragma once

#include <QFutureWatcher>
#include <QImage>
#include <QObject>
#include <QRectF>
#include <memory>
#include <optional>

#include "renderer/image/image.h"
#include "renderer/job/preview_stages.h"
#include "renderer/transport/render.h"

class QAction;
class QKeyEvent;
class QMenu;
class QMouseEvent;
class QWidget;

namespace editor {

struct FramedRegion;
class RenderPanel;
class ScaleBar;
class SceneView;

/// The display mode Rendered of a 3D view: shows the preview of the Render dock in the view, at its size and
/// from its camera, while the mode is on: its colours, or the error of its pixels. A rectangle may limit
/// what is rendered and shown.
class RenderedMode : public QObject {
  Q_OBJECT

 public:
  /// All outlive it; the window holds the actions.
  RenderedMode(SceneView& view, RenderPanel& panel, QWidget& window);
  ~RenderedMode() override;

  /// Adds the actions of the mode.
  void fill(QMenu& menu);
  /// The region in fractions of the view's width and height, from the upper left; empty for the whole view.
  const std::optional<QRectF>& region() const { return region_; }
  /// The region in pixels of the view, with its camera; nothing without a region, or in an orthographic view.
  std::optional<FramedRegion> framed_region() const;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  using SharedImage = std::shared_ptr<const image::Image>;
  using ScreenImage = std::shared_ptr<const QImage>;

  void make_actions(QWidget& window);
  bool is_on() const;
  void follow_view();
  void take(const SharedImage& image, const transport::RenderProgress& progress);
  void convert();
  SharedImage shown_error() const;
  void show_error_scale();
  QSize size_in_pixels() const;
  std::optional<job::PreviewRegion> preview_region() const;
  void show_converted();
  void show_note();
  void choose_region(bool is_wanted);
  void end_choice(const std::optional<QRectF>& region);
  bool press_key(const QKeyEvent& event);
  bool drag(const QMouseEvent& event);

  SceneView& view_;
  RenderPanel& panel_;
  QAction* limit_ = nullptr;
  QAction* denoise_ = nullptr;
  ScaleBar* error_scale_;  ///< over the view
  std::optional<QRectF> region_;
  bool is_choosing_ = false;           ///< the region
  std::optional<QPointF> pressed_at_;  ///< where the drag of the region began
  QPointF dragged_to_;
  SharedImage waiting_;  ///< to be converted
  SharedImage latest_;   ///< of the preview
  double done_ = 0;
  QFutureWatcher<ScreenImage> conversion_;
};

}  // namespace editor
