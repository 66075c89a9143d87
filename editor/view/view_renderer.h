#pragma once

#include <QImage>
#include <QObject>
#include <QPolygonF>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>

#include "editor/graphics/graphics_driver.h"
#include "editor/graphics/graphics_thread.h"
#include "editor/view/view_state.h"

namespace editor {

class ViewDrawing;

/// What a view shows of a state.
struct ViewImage {
  QImage image;
  QSize size;              ///< that was asked for; an image that the driver cannot draw is smaller
  std::int64_t state = 0;  ///< its number
  bool is_full = false;    ///< in full detail, perhaps with edges that are still being smoothed
  bool is_done = false;    ///< nothing is left to improve
};

/// A box or a lasso, what was to be seen where it was made, and how it selects.
struct ViewRegion {
  ViewState state;
  QPolygonF polygon;             ///< pixels of the window from the upper left
  bool selects_through = false;  ///< hidden faces too, and not only those that are seen
};

/// Draws a view in a thread of its own. Of several states only the latest counts; while nothing new is asked
/// for, its picture becomes better.
class ViewRenderer : public QObject {
  Q_OBJECT

 public:
  explicit ViewRenderer(const GraphicsDriver& driver = {}, QObject* parent = nullptr);
  ~ViewRenderer() override;

  void show(const ViewState& state);
  /// Shows the region's state, finds what is in it, and says that by `selected`. Of several regions only the
  /// latest counts.
  void select(const ViewRegion& region);

 signals:
  void drawn(const editor::ViewImage& image);
  void selected(const editor::FaceSelection& selection, std::int64_t state);
  /// The scene is drawn otherwise than it should be, which holds as long as it is shown.
  void warned(const QString& text);

 private:
  /// What the thread is to do next.
  struct Orders {
    std::optional<ViewState> state;
    std::optional<ViewRegion> region;
    bool is_end = false;

    bool empty() const { return !state && !region && !is_end; }
  };

  void order(const std::function<void(Orders&)>& change);

  // In the thread.
  void run(QOpenGLContext* context);
  void make_drawing(QOpenGLContext* context);
  Orders next_orders();
  bool has_orders();
  void show_in_thread(const ViewState& state);
  void select_in_thread(const ViewRegion& region);
  void tell_image();
  void tell_shortcomings();
  void warn(const QString& text);

  const GraphicsDriver driver_;
  std::mutex mutex_;
  std::condition_variable ordered_;
  Orders orders_;  // by the mutex
  bool is_running_ = false;
  // Of the thread:
  std::unique_ptr<ViewDrawing> drawing_;  // null: nothing can be drawn
  QSize asked_size_;
  QStringList told_;  // of what is shown
  GraphicsThread thread_;
};

}  // namespace editor
