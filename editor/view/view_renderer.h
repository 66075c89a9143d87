#pragma once

#include <QImage>
#include <QObject>
#include <QPainterPath>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>

#include "editor/graphics/graphics_driver.h"
#include "editor/graphics/graphics_thread.h"
#include "editor/view/view_state.h"

namespace editor {

class ViewDrawing;

/// The rendered image of a view state.
struct ViewImage {
  QImage image;
  QSize size;              ///< requested size; an image that exceeds the driver's limits is smaller
  std::int64_t state = 0;  ///< number of the state
  bool is_full = false;    ///< in full detail, perhaps not antialiased yet
  bool is_done = false;    ///< fully antialiased
};

/// A region of the image, the view state in which it was drawn, and how it selects.
struct ViewRegion {
  ViewState state;
  QPainterPath path;             ///< logical pixels from the upper left
  bool selects_through = false;  ///< whether to select occluded faces, too
};

/// Renders a view in a thread. Only the latest state counts; while it is unchanged, its image is refined.
class ViewRenderer : public QObject {
  Q_OBJECT

 public:
  explicit ViewRenderer(const GraphicsDriver& driver = {}, QObject* parent = nullptr);
  ~ViewRenderer() override;

  void show(const ViewState& state);
  /// Finds the faces in a region of its view state, and emits `selected`. Only the latest region counts.
  void select(const ViewRegion& region);

 signals:
  void drawn(const editor::ViewImage& image);
  void selected(const editor::FaceSelection& selection, std::int64_t state);
  /// Emitted when the scene is not drawn as it should be, once per shown scene.
  void warned(const QString& text);

 private:
  /// The pending requests of the thread.
  struct Requests {
    std::optional<ViewState> state;
    std::optional<ViewRegion> region;
    bool is_end = false;

    bool empty() const { return !state && !region && !is_end; }
  };

  void request(const std::function<void(Requests&)>& change);

  // Run in the thread.
  void run(QOpenGLContext* context);
  void make_drawing(QOpenGLContext* context);
  Requests next_requests();
  bool has_requests();
  void show_in_thread(const ViewState& state);
  void select_in_thread(const ViewRegion& region);
  void tell_image();
  void tell_shortcomings();
  void warn(const QString& text);

  const GraphicsDriver driver_;
  std::mutex mutex_;
  std::condition_variable requested_;
  Requests requests_;  // by the mutex
  bool is_running_ = false;
  // Used in the thread:
  std::unique_ptr<ViewDrawing> drawing_;  // null: nothing can be drawn
  QSize asked_size_;
  QStringList told_;  // of what is shown
  GraphicsThread thread_;
};

}  // namespace editor
