// The gestures and keys of the view.
#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <cmath>

#include <fmt/format.h>

#include "editor/view/region_selection.h"
#include "editor/view/scene_view.h"

namespace editor {
namespace {

/// Radians a pixel of the window, and a press of a key.
constexpr double OrbitPerPixel = 0.008;
constexpr double LookPerPixel = 0.004;
constexpr double OrbitPerKey = 0.1;
/// Parts of the picture's height a press of a key.
constexpr double PanPerKey = 0.05;
constexpr double ZoomPerStep = 0.85;

grf::Vec2d to_vector(const QPointF& point) { return {point.x(), point.y()}; }

/// How far one flies in a second, at this distance of what is looked at.
double speed_at(double distance) { return 0.8 * distance; }

std::string surface_text(const Look& look, bool is_light) {
  if (is_light) return "light";
  std::string text = look.brdf ? look.brdf->keyword : "diffuse by default";
  if (!look.texture.empty()) text += ", textured";
  if (look.emission) text += ", emits";
  return text;
}

}  // namespace

grf::Vec2d SceneView::place_at(const QPointF& pixel) const {
  return {2 * pixel.x() / window_size().x - 1, 1 - 2 * pixel.y() / window_size().y};
}

std::optional<SceneHit> SceneView::hit_at(const QPointF& pixel) const {
  return intersect(*objects_, geometry_.shapes(), camera_.ray(place_at(pixel), aspect()));
}

std::optional<FaceId> SceneView::face_at(const QPointF& pixel) const {
  const std::optional<SceneHit> hit = hit_at(pixel);
  return hit ? std::optional(hit->face) : std::nullopt;
}

void SceneView::mousePressEvent(QMouseEvent* event) {
  setFocus(Qt::MouseFocusReason);
  if (gesture_ != Gesture::None) return;
  pressed_at_ = last_at_ = event->position();
  is_click_ = true;
  shows_middle_ = false;
  if (event->button() == Qt::MiddleButton) {
    gesture_ = event->modifiers().testFlag(Qt::ShiftModifier) ? Gesture::Pan : Gesture::Orbit;
  } else if (event->button() == Qt::RightButton) {
    gesture_ = Gesture::Look;
  } else if (event->button() == Qt::LeftButton) {
    start_gesture(event);
  }
}

void SceneView::start_gesture(QMouseEvent* event) {
  taken_ = handle_at(handles_, camera_, to_vector(event->position()), window_size());
  taken_offset_ = grf::Vec3d(0);
  region_.clear();
  if (taken_) {
    gesture_ = Gesture::Handle;
  } else if (event->modifiers() == Qt::NoModifier && !is_lasso_ && !hit_at(event->position())) {
    gesture_ = Gesture::Orbit;
  } else {
    gesture_ = Gesture::Region;
    draws_lasso_ = is_lasso_ || event->modifiers().testFlag(Qt::AltModifier);
    if (draws_lasso_) region_ << event->position();
  }
}

void SceneView::mouseMoveEvent(QMouseEvent* event) {
  const QPointF at = event->position();
  const QPointF way = at - last_at_;
  if (is_click_ && (at - pressed_at_).manhattanLength() >= QApplication::startDragDistance())
    is_click_ = false;
  if (gesture_ == Gesture::None || is_click_) {
    hovered_at_ = at;
    if (!hover_timer_.isActive()) hover_timer_.start();
    return;
  }
  last_at_ = at;
  ViewCamera camera = camera_;
  switch (gesture_) {
    case Gesture::None:
      break;
    case Gesture::Orbit:
      camera.orbit(-way.x() * OrbitPerPixel, way.y() * OrbitPerPixel);
      break;
    case Gesture::Pan:
      camera.pan(-way.x() / window_size().y, way.y() / window_size().y);
      break;
    case Gesture::Look:
      camera.look(way.x() * LookPerPixel, -way.y() * LookPerPixel);
      break;
    case Gesture::Region:
      if (draws_lasso_) {
        region_ << at;
      } else {
        region_ = QPolygonF(QRectF(pressed_at_, at).normalized());
      }
      update();
      break;
    case Gesture::Handle:
      drag_handle(at, event->modifiers().testFlag(Qt::ShiftModifier));
      break;
  }
  move_camera(camera);
}

void SceneView::mouseReleaseEvent(QMouseEvent* event) {
  const bool ends =
      (event->button() == Qt::MiddleButton && (gesture_ == Gesture::Orbit || gesture_ == Gesture::Pan)) ||
      (event->button() == Qt::RightButton && gesture_ == Gesture::Look) || event->button() == Qt::LeftButton;
  if (!ends) return;
  const Gesture gesture = std::exchange(gesture_, Gesture::None);
  if (gesture == Gesture::Look) {
    flying_keys_.clear();
    fly_timer_.stop();
  } else if (gesture == Gesture::Handle) {
    end_handle();
  } else if (is_click_ && event->button() == Qt::LeftButton &&
             (gesture == Gesture::Orbit || gesture == Gesture::Region)) {
    click(event->position(), event->modifiers());
  } else if (gesture == Gesture::Region) {
    end_region(event->modifiers());
  }
  update();
}

void SceneView::drag_handle(const QPointF& pixel, bool along_axis) {
  const SceneHandle& handle = handles_[*taken_];
  taken_offset_ =
      dragged(handle.grip, camera_, to_vector(pressed_at_), to_vector(pixel), window_size(), along_axis) -
      handle.grip;
  emit object_moving(handle.id, handle.position + taken_offset_);
  draw();
}

void SceneView::end_handle() {
  SceneHandle& handle = handles_[*taken_];
  taken_.reset();
  draw();
  if (is_click_) return;
  // It stays there until the scene says where it is.
  handle = moved(handle, taken_offset_);
  emit object_moved(HandleId(handle.id), grf::Vec3d(handle.position));
}

void SceneView::end_region(Qt::KeyboardModifiers modifiers) {
  if (region_.size() < 3) return;
  QPolygonF region;
  for (const QPointF& point : region_) region << point * devicePixelRatioF();
  region_.clear();
  ++number_;
  region_order_ = RegionOrder{number_, objects_, modifiers};
  const bool has_faces = mode_ != DisplayMode::Wireframe && mode_ != DisplayMode::Points;
  renderer_.select({state(), region, selects_through_ || !has_faces});
}

void SceneView::take_region(const FaceSelection& selected, std::int64_t state) {
  if (!region_order_ || region_order_->state != state) return;
  const RegionOrder order = *std::exchange(region_order_, std::nullopt);
  // Of a scene that is another one by now nothing is selected.
  if (order.objects == objects_) make_selection(selected, order.modifiers);
}

void SceneView::click(const QPointF& pixel, Qt::KeyboardModifiers modifiers) {
  FaceSelection made(*objects_);
  const auto hit = hit_at(pixel);
  if (hit) made.set(hit->face);
  // A click beside everything with a modifier changes nothing.
  if (!hit && modifiers != Qt::NoModifier) return;
  make_selection(std::move(made), modifiers);
}

void SceneView::toggle_middle() {
  const auto hit = hit_at(QPointF(width() / 2.0, height() / 2.0));
  if (!hit) return;
  FaceSelection made = *selection_;
  made.set(hit->face, !made.has(hit->face));
  make_selection(std::move(made), Qt::NoModifier);
}

void SceneView::make_selection(FaceSelection made, Qt::KeyboardModifiers modifiers) {
  if (modifiers.testFlag(Qt::ControlModifier)) {
    FaceSelection all = *selection_;
    all.remove(made);
    made = std::move(all);
  } else if (modifiers.testFlag(Qt::ShiftModifier)) {
    made.add(*selection_);
  }
  if (made == *selection_) return;
  set_selection(made);
  emit selection_made(made);
}

void SceneView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  const ViewRay ray = camera_.ray(place_at(event->position()), aspect());
  const auto hit = intersect(*objects_, geometry_.shapes(), ray);
  if (!hit) return;
  ViewCamera camera = camera_;
  camera.set_target(ray.at(hit->distance));
  move_camera(camera);
}

void SceneView::wheelEvent(QWheelEvent* event) {
  const double steps = event->angleDelta().y() / 120.0;
  if (steps == 0) return;
  ViewCamera camera = camera_;
  camera.zoom(std::pow(ZoomPerStep, steps), place_at(event->position()), aspect());
  move_camera(camera);
  event->accept();
}

void SceneView::keyPressEvent(QKeyEvent* event) {
  const int key = event->key();
  const bool has_shift = event->modifiers().testFlag(Qt::ShiftModifier);
  const bool has_other = event->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier);
  static const std::set<int> keys_to_fly = {Qt::Key_W, Qt::Key_A, Qt::Key_S, Qt::Key_D, Qt::Key_Q, Qt::Key_E};
  if (gesture_ == Gesture::Look && keys_to_fly.contains(key)) {
    flying_keys_.insert(key);
    is_click_ = false;
    if (!fly_timer_.isActive()) fly_timer_.start();
  } else if (key == Qt::Key_Escape && gesture_ != Gesture::None) {
    cancel_gesture();
  } else if (has_other || !(navigate_by_key(key, has_shift) || choose_view_by_key(key))) {
    QWidget::keyPressEvent(event);
    return;
  }
  if (!shows_middle_ && gesture_ == Gesture::None) {
    shows_middle_ = true;
    update();
  }
}

bool SceneView::navigate_by_key(int key, bool has_shift) {
  static const std::map<int, QPointF> ways = {
      {Qt::Key_Left, {-1, 0}}, {Qt::Key_Right, {1, 0}}, {Qt::Key_Up, {0, 1}}, {Qt::Key_Down, {0, -1}}};
  ViewCamera camera = camera_;
  if (const auto way = ways.find(key); way != ways.end()) {
    const QPointF step = way->second * (has_shift ? PanPerKey : OrbitPerKey);
    has_shift ? camera.pan(step.x(), step.y()) : camera.orbit(step.x(), step.y());
  } else if (key == Qt::Key_Plus || key == Qt::Key_Equal) {
    camera.zoom(ZoomPerStep, grf::Vec2d(0), aspect());
  } else if (key == Qt::Key_Minus) {
    camera.zoom(1 / ZoomPerStep, grf::Vec2d(0), aspect());
  } else if (key == Qt::Key_Space) {
    toggle_middle();
  } else {
    return false;
  }
  move_camera(camera);
  return true;
}

bool SceneView::choose_view_by_key(int key) {
  ViewCamera camera = camera_;
  switch (key) {
    case Qt::Key_F:
      frame_selection();
      return true;
    case Qt::Key_Home:
      frame_all();
      return true;
    case Qt::Key_1:
      camera.look_from(StandardView::Front);
      break;
    case Qt::Key_3:
      camera.look_from(StandardView::Right);
      break;
    case Qt::Key_7:
      camera.look_from(StandardView::Top);
      break;
    case Qt::Key_9:
      camera.look_from_opposite();
      break;
    case Qt::Key_5:
      camera.set_orthographic(!camera.is_orthographic());
      break;
    default:
      return false;
  }
  move_camera(camera);
  return true;
}

void SceneView::keyReleaseEvent(QKeyEvent* event) {
  if (!event->isAutoRepeat()) flying_keys_.erase(event->key());
  if (flying_keys_.empty()) fly_timer_.stop();
  QWidget::keyReleaseEvent(event);
}

void SceneView::fly() {
  const double step = speed_at(camera_.distance()) * fly_timer_.interval() / 1000;
  const auto along = [&](Qt::Key forwards, Qt::Key backwards) {
    return step * (flying_keys_.contains(forwards) ? 1 : flying_keys_.contains(backwards) ? -1 : 0);
  };
  ViewCamera camera = camera_;
  camera.fly(along(Qt::Key_D, Qt::Key_A), along(Qt::Key_E, Qt::Key_Q), along(Qt::Key_W, Qt::Key_S));
  move_camera(camera);
}

void SceneView::focusInEvent(QFocusEvent* event) {
  // Who comes by keyboard goes on by keyboard.
  const Qt::FocusReason reason = event->reason();
  if (reason == Qt::TabFocusReason || reason == Qt::BacktabFocusReason) shows_middle_ = true;
  update();
  QWidget::focusInEvent(event);
}

void SceneView::focusOutEvent(QFocusEvent* event) {
  flying_keys_.clear();
  fly_timer_.stop();
  update();
  QWidget::focusOutEvent(event);
}

void SceneView::leaveEvent(QEvent* event) {
  hover_timer_.stop();
  if (hovered_handle_.has_value()) {
    hovered_handle_.reset();
    draw();
  }
  emit hovered({});
  QWidget::leaveEvent(event);
}

void SceneView::tell_hovered() {
  const auto handle = handle_at(handles_, camera_, to_vector(hovered_at_), window_size());
  const std::optional<HandleId> id = handle ? std::optional(handles_[*handle].id) : std::nullopt;
  if (id != hovered_handle_) {
    hovered_handle_ = id;
    draw();
  }
  if (handle) {
    emit hovered(QString::fromStdString(handles_[*handle].name));
    return;
  }
  const auto hit = hit_at(hovered_at_);
  if (!hit) {
    emit hovered({});
    return;
  }
  const MeshObject& mesh = objects_->meshes[hit->face.mesh];
  const Look& look = mesh.looks[(*mesh.mesh->surface_of_face)[hit->face.face]];
  emit hovered(QString::fromStdString(fmt::format("{} · face {} · {}",
                                                  mesh.name.empty() ? "mesh without a name" : mesh.name,
                                                  hit->face.face, surface_text(look, mesh.is_light))));
}

void SceneView::cancel_gesture() {
  gesture_ = Gesture::None;
  taken_.reset();
  region_.clear();
  flying_keys_.clear();
  fly_timer_.stop();
  update();
  draw();
}

}  // namespace editor
