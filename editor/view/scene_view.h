// SceneView is the 3D view of a scene.
#pragma once

#include <QPainterPath>
#include <QTimer>
#include <QWidget>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "editor/document/face_selection.h"
#include "editor/view/camera_navigation.h"
#include "editor/view/frame_renderer.h"
#include "editor/view/geometry_store.h"
#include "editor/view/region_gesture.h"
#include "editor/view/scene_handles.h"
#include "editor/view/texture_store.h"
#include "editor/view/view_renderer.h"

namespace editor {

struct SceneHit;

/// A point of a surface that is seen in a view, in world space.
struct SurfacePoint {
  FaceId face;
  grf::Vec3d position;
  grf::Vec3d normal;          ///< unit, toward the eye; interpolated where vertices have normals
  grf::Vec3d view_direction;  ///< from the eye
};

/// Displays a scene, and handles selection and dragging. It edits nothing: gestures emit signals, and their
/// effect arrives by `show` and `set_selection`. The image is rendered asynchronously in a thread, which also
/// evaluates boxes and lassos.
///
/// Pointer: a click selects a face, a drag from a face those in a box (with Alt or `set_lasso` in a lasso);
/// Shift adds, Ctrl removes. A click with Alt selects the face loop through the nearest edge, with Ctrl and
/// Alt the loop that crosses it. A drag from the background or with the middle button orbits, Shift and the
/// middle button pan, the wheel zooms about the pointer, with the right button held the view turns and W A S
/// D Q E fly. A double click sets the orbit centre.
///
/// Keys: arrows orbit (with Shift pan), + and - zoom, F frames the selection, Home all, 1 3 7 are the front,
/// right and top views, 9 the opposite, 5 toggles orthographic, Space toggles the face in the middle, Escape
/// cancels a gesture.
class SceneView : public QWidget {
  Q_OBJECT

 public:
  explicit SceneView(QWidget* parent = nullptr, const GraphicsDriver& driver = {},
                     const ImageProcess& images = ImageProcess());

  using QWidget::show;
  /// Shows another state of the scene. The selection is kept if the meshes have as many faces as before.
  void show(std::shared_ptr<const SceneObjects> objects);
  const std::shared_ptr<const SceneObjects>& shared_objects() const { return objects_; }
  const SceneObjects& objects() const { return *objects_; }
  /// Draws these objects in place of the scene's, while a gesture moves some of them; null ends that.
  void show_moved(std::shared_ptr<const SceneObjects> objects);
  /// Sets what draws lines in front of the scene, in pixels of the window.
  using GizmoLines =
      std::function<std::vector<OverlayLine>(const ViewCamera& camera, const grf::Vec2d& size)>;
  void set_gizmo(const GizmoLines& lines) { gizmo_ = lines; }
  /// Sets the selection, which belongs to the shown objects.
  void set_selection(const FaceSelection& selection);
  const FaceSelection& selection() const { return *selection_; }
  /// Sets the faces of the shown objects that are neither drawn nor selected, and those that are drawn, but
  /// not selected by the pointer.
  void set_hidden_and_locked(const FaceSelection& hidden, const FaceSelection& locked);
  void set_camera(const ViewCamera& camera);
  const ViewCamera& camera() const { return navigation_.camera(); }
  /// Moves the camera as a gesture does: with `camera_moved`.
  void move_camera(const ViewCamera& camera) { navigation_.move(camera); }
  void frame_all() { frame(objects_->bounds); }
  void frame_selection();
  /// Handles a key that moves the camera or selects. Returns whether it is one.
  bool press(int key, bool has_shift = false);

  void set_mode(DisplayMode mode);
  DisplayMode mode() const { return style_.mode; }
  void set_vertex_normals(bool are_shown);
  void set_face_normals(bool are_shown);
  void set_grid(bool is_shown);
  /// Makes a drag draw a lasso instead of a box.
  void set_lasso(bool is_lasso) { is_lasso_ = is_lasso; }
  /// Sets what a tool that selects regions draws in front of the view, in logical pixels, and that gizmos
  /// stand back for it; an empty function ends that.
  using ToolPainter = std::function<void(QPainter& painter)>;
  void set_tool_painter(const ToolPainter& painter);
  bool has_region_tool() const { return static_cast<bool>(tool_painter_); }
  /// Shows an image of the renderer in place of the faces where it is opaque, stretched to the view, below
  /// the selection, lines and handles; null ends that.
  void set_rendered(std::shared_ptr<const QImage> image);
  const std::shared_ptr<const QImage>& rendered() const { return rendered_; }
  /// Sets the environment that is seen behind the scene, and lights it, in the display mode BRDF; null: none.
  void set_environment(std::shared_ptr<const SceneEnvironment> environment);
  const std::shared_ptr<const SceneEnvironment>& environment() const { return environment_; }
  /// Shows a text in the upper right corner; an empty one ends that.
  void set_note(const QString& note);
  const QString& note() const { return note_; }
  /// Makes regions select occluded faces, too.
  void set_select_through(bool selects_through) { selects_through_ = selects_through; }
  /// Draws the border and the thirds of an image of this aspect, width over height; none for no aspect.
  void set_framing(std::optional<double> image_aspect) {
    if (image_aspect == framing_) return;
    framing_ = image_aspect;
    draw();
  }
  /// Sets the render camera and its image's aspect ratio; without a camera none is drawn.
  void set_render_camera(const std::optional<transport::View>& camera, double aspect = 1.25);

  /// The size of the window in logical pixels.
  grf::Vec2d window_size() const;
  /// Draws a new image soon.
  void draw();

  /// Whether the image is in full detail and antialiased, and nothing is being loaded.
  bool is_complete() const;
  /// Whether the image of the current scene is in full detail, perhaps not antialiased yet.
  bool is_full() const;
  /// Whether the faces of a region are being found.
  bool is_selecting() const { return pending_region_.has_value(); }
  /// The face that a click at this position of the widget would select.
  std::optional<FaceId> face_at(const QPointF& pixel) const;
  /// The point of the surface there.
  std::optional<SurfacePoint> surface_at(const QPointF& pixel) const;
  /// Selects as a click at this position of the widget does.
  void click(const QPointF& pixel, Qt::KeyboardModifiers modifiers);
  /// Selects the faces in a region of the widget, with these modifiers of the pointer: Shift adds, Ctrl
  /// removes. They are found in a thread; a new region replaces one that is still evaluated.
  void select_region(const QPainterPath& region, Qt::KeyboardModifiers modifiers);
  /// The handles of lights, observers and the camera.
  const std::vector<SceneHandle>& handles() const { return handles_.handles(); }

 signals:
  void selection_made(const editor::FaceSelection& selection);
  /// Emitted with the objects under a click, in a box or in a lasso; the modifiers are those of the pointer.
  void objects_picked(const std::vector<grf::ScenePath>& paths, Qt::KeyboardModifiers modifiers);
  /// Emitted once a region is evaluated.
  void region_selected();
  void camera_moved();
  /// Emitted when camera, size or display mode of the view change, whatever the cause.
  void view_changed();
  /// Emitted once a dragged object is released, with its new SceneHandle::position. An AreaLight's new corner
  /// is `position * to_world.inverse()`.
  void object_moved(const editor::HandleId& object, const grf::Vec3d& position);
  /// Emitted with a description of what is under the pointer; empty for nothing.
  void hovered(const QString& text);
  /// Emitted when something cannot be shown, such as a texture.
  void message(const QString& text);
  /// See ViewRenderer.
  void warned(const QString& text);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  enum class Gesture { None, Navigation, Region, Handle };
  /// A region to be evaluated.
  struct PendingRegion {
    std::int64_t state = 0;  ///< number of the view state
    std::shared_ptr<const SceneObjects> objects;
    Qt::KeyboardModifiers modifiers;
  };

  // Display
  ViewState state() const;
  FrameRequest request() const;
  QSize picture_size() const;
  double aspect() const { return window_size().x / window_size().y; }
  grf::Box3d drawn_bounds() const;
  void place_handles();
  void frame(const grf::Box3d& box);
  void paint_gesture(QPainter& painter) const;
  void paint_note(QPainter& painter) const;

  // Picking
  grf::Vec2d place_at(const QPointF& pixel) const;
  std::optional<SceneHit> hit_at(const QPointF& pixel) const;
  void tell_hovered();

  // Gestures
  void begin_navigation(CameraNavigation::Drag drag);
  void begin_gesture(const QPointF& at, Qt::KeyboardModifiers modifiers);
  void cancel_gesture();
  void end_handle();
  void take_region(FaceSelection selected, std::int64_t state);
  void toggle_middle();
  void remove_unselectable(FaceSelection& faces) const;
  void make_selection(FaceSelection made, Qt::KeyboardModifiers modifiers);

  std::shared_ptr<const SceneObjects> objects_;  // never null, as the selection
  std::shared_ptr<const SceneObjects> moved_;    // drawn in their place, if any
  std::shared_ptr<const FaceSelection> selection_;
  std::shared_ptr<const FaceSelection> hidden_;
  FaceSelection locked_;
  GeometryStore geometry_;
  TextureStore textures_;
  CameraNavigation navigation_;
  HandleGesture handles_;
  GizmoLines gizmo_;
  ToolPainter tool_painter_;
  std::shared_ptr<const QImage> rendered_;
  std::shared_ptr<const SceneEnvironment> environment_;
  QString note_;
  RegionGesture region_;
  ViewStyle style_;  // without colours
  bool has_grid_ = true;
  bool is_lasso_ = false;
  bool selects_through_ = false;
  std::optional<double> framing_;  ///< aspect of the image whose border is drawn
  std::optional<transport::View> render_camera_;
  double render_aspect_ = 1.25;
  std::int64_t number_ = 0;    // of what is to be seen
  bool is_requested_ = false;  // it will be asked for in the next turn of the event loop
  ViewImage shown_;
  std::optional<PendingRegion> pending_region_;
  Gesture gesture_ = Gesture::None;
  Qt::MouseButton button_ = Qt::NoButton;  // that began it
  bool is_click_ = false;                  // the pointer has not moved since it was pressed
  QPointF pressed_at_, last_at_, hovered_at_;
  QTimer hover_timer_;
  bool shows_middle_ = false;
  ViewRenderer renderer_;
};

}  // namespace editor
