#include "editor/view/scene_view.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLinearGradient>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <utility>

#include "editor/appearance/theme.h"
#include "editor/view/hover_text.h"
#include "editor/view/region_selection.h"
#include "editor/view/screen_geometry.h"
#include "editor/view/view_overlay.h"

namespace editor {
namespace {

grf::Vec2d to_vector(const QPointF& point) { return {point.x(), point.y()}; }

}  // namespace

SceneView::SceneView(QWidget* parent, const GraphicsDriver& driver, const ImageProcess& images)
    : QWidget(parent),
      objects_(std::make_shared<const SceneObjects>()),
      selection_(std::make_shared<const FaceSelection>()),
      hidden_(selection_),
      textures_(images),
      renderer_(driver) {
  setAttribute(Qt::WA_OpaquePaintEvent);
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setMinimumSize(160, 120);
  setAccessibleName(tr("3D view"));
  setAccessibleDescription(tr(
      "The scene. Arrow keys orbit, with Shift they pan, plus and minus zoom, Space selects the face in the "
      "middle, F frames the selection, Home frames all, 1, 3, 7 and 9 are standard views, 5 changes "
      "perspective."));
  hover_timer_.setSingleShot(true);
  hover_timer_.setInterval(30);
  connect(&hover_timer_, &QTimer::timeout, this, &SceneView::tell_hovered);
  connect(&navigation_, &CameraNavigation::moved, this, [this] {
    draw();
    emit view_changed();
    emit camera_moved();
  });
  connect(&geometry_, &GeometryStore::changed, this, &SceneView::draw);
  connect(&textures_, &TextureStore::failed, this, &SceneView::message);
  connect(&textures_, &TextureStore::changed, this, &SceneView::draw);
  connect(&renderer_, &ViewRenderer::drawn, this, [this](const ViewImage& image) {
    shown_ = image;
    update();
  });
  connect(&renderer_, &ViewRenderer::selected, this, &SceneView::take_region);
  connect(&renderer_, &ViewRenderer::warned, this, &SceneView::warned);
}

// Display

void SceneView::show(std::shared_ptr<const SceneObjects> objects) {
  cancel_gesture();
  moved_.reset();
  objects_ = std::move(objects);
  if (!selection_->fits(*objects_)) {
    selection_ = std::make_shared<const FaceSelection>(*objects_);
  }
  if (!hidden_->fits(*objects_)) hidden_ = std::make_shared<const FaceSelection>(*objects_);
  if (!locked_.fits(*objects_)) locked_ = FaceSelection(*objects_);
  geometry_.set_objects(*objects_);
  std::vector<std::string> paths;
  for (const MeshObject& mesh : objects_->meshes) {
    for (const FlatSurface& flat_surface : mesh.flat_surfaces) {
      if (!flat_surface.texture.empty()) paths.push_back(flat_surface.texture);
    }
  }
  textures_.set_paths(paths);
  place_handles();
  draw();
}

void SceneView::show_moved(std::shared_ptr<const SceneObjects> objects) {
  moved_ = std::move(objects);
  place_handles();
  draw();
}

void SceneView::set_selection(const FaceSelection& selection) {
  selection_ = std::make_shared<const FaceSelection>(selection);
  draw();
}

void SceneView::set_hidden_and_locked(const FaceSelection& hidden, const FaceSelection& locked) {
  locked_ = locked;
  if (hidden == *hidden_) return;
  hidden_ = std::make_shared<const FaceSelection>(hidden);
  draw();
}

void SceneView::set_camera(const ViewCamera& camera) {
  navigation_.set_camera(camera);
  draw();
  emit view_changed();
}

void SceneView::frame(const grf::Box3d& box) {
  ViewCamera framing = camera();
  framing.frame(box, aspect());
  move_camera(framing);
}

void SceneView::frame_selection() {
  if (selection_->empty()) return frame_all();
  frame(bounds_of(*objects_, *selection_));
}

void SceneView::set_mode(DisplayMode mode) {
  style_.mode = mode;
  draw();
  emit view_changed();
}

void SceneView::set_vertex_normals(bool are_shown) {
  style_.has_vertex_normals = are_shown;
  draw();
}

void SceneView::set_face_normals(bool are_shown) {
  style_.has_face_normals = are_shown;
  draw();
}

void SceneView::set_grid(bool is_shown) {
  has_grid_ = is_shown;
  draw();
}

void SceneView::set_tool_painter(const ToolPainter& painter) {
  const bool hides_gizmo = static_cast<bool>(painter) != static_cast<bool>(tool_painter_);
  tool_painter_ = painter;
  if (hides_gizmo) draw();
  update();
}

void SceneView::set_rendered(std::shared_ptr<const QImage> image) {
  if (image == rendered_) return;
  rendered_ = std::move(image);
  draw();
}

void SceneView::set_environment(std::shared_ptr<const SceneEnvironment> environment) {
  if (environment == environment_) return;
  environment_ = std::move(environment);
  draw();
}

void SceneView::set_note(const QString& note) {
  if (note == note_) return;
  note_ = note;
  update();
}

void SceneView::set_render_camera(const std::optional<transport::View>& camera, double image_aspect) {
  render_camera_ = camera;
  render_aspect_ = image_aspect;
  if (gesture_ == Gesture::Handle) cancel_gesture();
  place_handles();
  draw();
}

void SceneView::place_handles() {
  const double size = objects_->bounds.isEmpty() ? 0.2 : objects_->bounds.size().length() / 30;
  handles_.set_handles(
      handles_of(moved_ ? *moved_ : *objects_, render_camera_, render_aspect_, std::max(size, 1e-6)));
}

bool SceneView::is_full() const {
  return shown_.is_full && shown_.state == number_ && geometry_.has_all_meshes() && textures_.is_complete();
}

bool SceneView::is_complete() const {
  return is_full() && shown_.is_done && geometry_.is_complete() && !is_selecting();
}

grf::Vec2d SceneView::window_size() const {
  return {double(std::max(width(), 1)), double(std::max(height(), 1))};
}

FrameRequest SceneView::request() const {
  const Theme theme = theme_of(palette());
  FrameRequest request;
  request.camera = camera();
  request.bounds = drawn_bounds();
  request.style = style_;
  request.style.lines = colours_of(theme).text;
  request.style.normals = series_colour(theme, 1);
  request.style.pixel_ratio = static_cast<float>(devicePixelRatioF());
  request.aspect = aspect();
  request.environment = environment_;
  return request;
}

QSize SceneView::picture_size() const {
  const double ratio = devicePixelRatioF();
  return {std::max(1, qRound(width() * ratio)), std::max(1, qRound(height() * ratio))};
}

/// The bounds of everything with a depth: the scene, its lights and the grid.
grf::Box3d SceneView::drawn_bounds() const {
  grf::Box3d box = objects_->bounds;
  for (const SceneHandle& handle : handles_.handles()) {
    for (const auto& [from, to] : handle.lines) {
      box.extendBy(from);
      box.extendBy(to);
    }
  }
  if (has_grid_) box.extendBy(ground_grid(objects_->bounds).bounds());
  return box;
}

// Changes of one turn of the event loop are drawn together.
void SceneView::draw() {
  ++number_;
  if (is_requested_ || !isVisible()) return;
  is_requested_ = true;
  QMetaObject::invokeMethod(
      this,
      [this] {
        is_requested_ = false;
        if (isVisible()) renderer_.show(state());
      },
      Qt::QueuedConnection);
}

ViewState SceneView::state() const {
  ViewState state;
  state.number = number_;
  state.objects = moved_ ? moved_ : objects_;
  state.selection = selection_;
  state.hidden = hidden_;
  state.shapes = geometry_.shapes();
  state.textures = textures_.textures();
  state.request = request();
  state.size = picture_size();
  state.rendered = rendered_;
  state.backplate_aspect = render_aspect_;
  state.screen = {window_size(), devicePixelRatioF()};
  state.colours = view_colours(palette());
  if (has_grid_) add_grid(ground_grid(objects_->bounds), camera(), height(), palette(), state.overlay);
  add_handles(handles_, camera(), window_size(), palette(), state.overlay);
  if (framing_) add_framing(*framing_, window_size(), palette(), state.overlay);
  if (gizmo_) state.overlay.push_back({gizmo_(camera(), window_size()), 2, 0, true});
  return state;
}

void SceneView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const QSizeF size = shown_.image.deviceIndependentSize();
  if (shown_.size == picture_size()) {
    // The size is explicit, since Qt ignores pixel ratios below 1, as of an image that the driver downscaled.
    painter.drawImage(QRectF(QPointF(), size), shown_.image);
  } else {
    // Centred, until an image of this size arrives.
    const ViewColours background = view_colours(palette());
    QLinearGradient gradient(0, 0, 0, height());
    gradient.setColorAt(0, background.background_top);
    gradient.setColorAt(1, background.background_bottom);
    painter.fillRect(rect(), gradient);
    painter.drawImage(QPointF((width() - size.width()) / 2, (height() - size.height()) / 2), shown_.image);
    // The window may have moved to a screen with another pixel ratio.
    if (!shown_.image.isNull()) draw();
  }
  paint_note(painter);
  paint_gesture(painter);
}

void SceneView::paint_note(QPainter& painter) const {
  if (note_.isEmpty()) return;
  const ThemeColours colours = colours_of(theme_of(palette()));
  QRect frame = painter.fontMetrics().boundingRect(note_).adjusted(-Grid, -Grid / 2, Grid, Grid / 2);
  frame.moveTopRight({width() - Grid, Grid});
  QColor ground = colours.window;
  ground.setAlphaF(0.85F);
  painter.fillRect(frame, ground);
  painter.setPen(colours.text);
  painter.drawText(frame, Qt::AlignCenter, note_);
}

void SceneView::paint_gesture(QPainter& painter) const {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(view_colours(palette()).accent, 1.5));
  if (gesture_ == Gesture::Region && !is_click_) painter.drawPolygon(region_.polygon());
  if (tool_painter_) tool_painter_(painter);
  if (!shows_middle_ || !hasFocus()) return;
  const QPointF middle(width() / 2.0, height() / 2.0);
  for (const QPointF& way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)}) {
    painter.drawLine(middle + way * 4, middle + way * 12);
  }
}

void SceneView::resizeEvent(QResizeEvent*) {
  draw();
  emit view_changed();
}

void SceneView::showEvent(QShowEvent*) { draw(); }

void SceneView::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) draw();
  QWidget::changeEvent(event);
}

// Gestures

void SceneView::tell_hovered() {
  const SceneHandle* handle = handles_.at(to_vector(hovered_at_), camera(), window_size());
  if (handles_.hover(handle)) draw();
  if (handle != nullptr) return emit hovered(QString::fromStdString(handle->name));
  const std::optional<SceneHit> hit = hit_at(hovered_at_);
  emit hovered(hit ? hover_text(*objects_, hit->face) : QString());
}

void SceneView::leaveEvent(QEvent* event) {
  hover_timer_.stop();
  if (handles_.hover(nullptr)) draw();
  emit hovered({});
  QWidget::leaveEvent(event);
}

void SceneView::mousePressEvent(QMouseEvent* event) {
  setFocus(Qt::MouseFocusReason);
  if (gesture_ != Gesture::None) return;
  pressed_at_ = last_at_ = event->position();
  button_ = event->button();
  is_click_ = true;
  shows_middle_ = false;
  using Drag = CameraNavigation::Drag;
  if (button_ == Qt::MiddleButton) {
    begin_navigation(event->modifiers().testFlag(Qt::ShiftModifier) ? Drag::Pan : Drag::Orbit);
  } else if (button_ == Qt::RightButton) {
    begin_navigation(Drag::Look);
  } else if (button_ == Qt::LeftButton) {
    begin_gesture(event->position(), event->modifiers());
  }
}

void SceneView::begin_navigation(CameraNavigation::Drag drag) {
  gesture_ = Gesture::Navigation;
  navigation_.begin(drag);
}

void SceneView::begin_gesture(const QPointF& at, Qt::KeyboardModifiers modifiers) {
  if (const SceneHandle* handle = handles_.at(to_vector(at), camera(), window_size())) {
    gesture_ = Gesture::Handle;
    handles_.begin(*handle, to_vector(at));
  } else if (modifiers == Qt::NoModifier && !is_lasso_ && !hit_at(at)) {
    begin_navigation(CameraNavigation::Drag::Orbit);
  } else {
    gesture_ = Gesture::Region;
    region_.begin(at, is_lasso_ || modifiers.testFlag(Qt::AltModifier));
  }
}

void SceneView::mouseMoveEvent(QMouseEvent* event) {
  const QPointF at = event->position();
  if (is_click_ && (at - pressed_at_).manhattanLength() >= QApplication::startDragDistance())
    is_click_ = false;
  if (gesture_ == Gesture::None || is_click_) {
    hovered_at_ = at;
    if (!hover_timer_.isActive()) hover_timer_.start();
    return;
  }
  const QPointF way = at - std::exchange(last_at_, at);
  if (gesture_ == Gesture::Navigation) {
    navigation_.drag(way, window_size().y);
  } else if (gesture_ == Gesture::Region) {
    region_.extend(at);
    update();
  } else {
    const bool along_axis = event->modifiers().testFlag(Qt::ShiftModifier);
    handles_.drag(to_vector(at), camera(), window_size(), along_axis);
    draw();
  }
}

void SceneView::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != button_) return;
  const Gesture gesture = std::exchange(gesture_, Gesture::None);
  navigation_.end_flying();
  if (gesture == Gesture::Handle) {
    end_handle();
  } else if (gesture != Gesture::None && is_click_) {
    if (button_ == Qt::LeftButton) click(event->position(), event->modifiers());
  } else if (gesture == Gesture::Region) {
    const QPolygonF drawn = region_.take();
    if (drawn.size() >= 3) select_region(path_of(drawn), event->modifiers());
  }
  update();
}

/// A dragged object stays there until the scene is updated.
void SceneView::end_handle() {
  const SceneHandle handle = handles_.end(!is_click_);
  draw();
  if (!is_click_) emit object_moved(handle.id, handle.position);
  if (is_click_ && !handle.id.path.empty()) emit objects_picked({handle.id.path}, Qt::NoModifier);
}

void SceneView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  const auto hit = hit_at(event->position());
  if (!hit) return;
  ViewCamera turned = camera();
  turned.set_target(camera().ray(place_at(event->position()), aspect()).at(hit->distance));
  move_camera(turned);
}

void SceneView::wheelEvent(QWheelEvent* event) {
  if (event->angleDelta().y() == 0) return;
  navigation_.zoom(event->angleDelta().y() / 120.0, place_at(event->position()), aspect());
  event->accept();
}

void SceneView::keyPressEvent(QKeyEvent* event) {
  const int key = event->key();
  const bool has_shift = event->modifiers().testFlag(Qt::ShiftModifier);
  const bool has_other = event->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier);
  if (gesture_ == Gesture::Navigation && button_ == Qt::RightButton && navigation_.begin_flying(key)) {
    is_click_ = false;
  } else if (key == Qt::Key_Escape && gesture_ != Gesture::None) {
    cancel_gesture();
  } else if (has_other || !press(key, has_shift)) {
    QWidget::keyPressEvent(event);
    return;
  }
  if (!shows_middle_ && gesture_ == Gesture::None) {
    shows_middle_ = true;
    update();
  }
}

bool SceneView::press(int key, bool has_shift) {
  if (navigation_.press(key, has_shift, aspect())) return true;
  if (key == Qt::Key_Space) {
    toggle_middle();
  } else if (key == Qt::Key_F) {
    frame_selection();
  } else if (key == Qt::Key_Home) {
    frame_all();
  } else {
    return false;
  }
  return true;
}

void SceneView::keyReleaseEvent(QKeyEvent* event) {
  if (!event->isAutoRepeat()) navigation_.end_flying(event->key());
  QWidget::keyReleaseEvent(event);
}

void SceneView::focusInEvent(QFocusEvent* event) {
  // Focus that came by keyboard shows the keyboard cursor.
  const Qt::FocusReason reason = event->reason();
  if (reason == Qt::TabFocusReason || reason == Qt::BacktabFocusReason) shows_middle_ = true;
  update();
  QWidget::focusInEvent(event);
}

void SceneView::focusOutEvent(QFocusEvent* event) {
  navigation_.end_flying();
  update();
  QWidget::focusOutEvent(event);
}

void SceneView::cancel_gesture() {
  if (std::exchange(gesture_, Gesture::None) == Gesture::Handle) handles_.end(false);
  region_.take();
  navigation_.end_flying();
  update();
  draw();
}

}  // namespace editor
