#include "editor/view/camera_navigation.h"

#include <cmath>
#include <map>

#include "editor/controls/gesture.h"

namespace editor {
namespace {

/// Radians per pixel of the window, and per key press.
constexpr double OrbitPerPixel = 0.008;
constexpr double LookPerPixel = 0.004;
constexpr double OrbitPerKey = 0.1;
/// Fractions of the image's height per key press.
constexpr double PanPerKey = 0.05;
constexpr double ZoomPerStep = 0.85;
/// Flying speed, in distances to the target per second.
constexpr double FlyingSpeed = 0.8;

}  // namespace

CameraNavigation::CameraNavigation() {
  fly_timer_.setInterval(16);
  connect(&fly_timer_, &QTimer::timeout, this, &CameraNavigation::fly);
}

void CameraNavigation::move(const ViewCamera& camera) {
  if (camera == camera_) return;
  camera_ = camera;
  emit moved();
}

void CameraNavigation::drag(const QPointF& way, double height) {
  ViewCamera camera = camera_;
  switch (drag_) {
    case Drag::Orbit:
      camera.orbit(-way.x() * OrbitPerPixel, way.y() * OrbitPerPixel);
      break;
    case Drag::Pan:
      camera.pan(-way.x() / height, way.y() / height);
      break;
    case Drag::Look:
      camera.look(way.x() * LookPerPixel, -way.y() * LookPerPixel);
      break;
  }
  move(camera);
}

void CameraNavigation::zoom(double steps, const grf::Vec2d& place, double aspect) {
  ViewCamera camera = camera_;
  camera.zoom(std::pow(ZoomPerStep, steps), place, aspect);
  move(camera);
}

bool CameraNavigation::press(int key, bool has_shift, double aspect) {
  static const std::map<int, double> zooms = {{Qt::Key_Plus, 1}, {Qt::Key_Equal, 1}, {Qt::Key_Minus, -1}};
  static const std::map<int, void (*)(ViewCamera&)> views = {
      {Qt::Key_1, [](ViewCamera& camera) { camera.look_from(StandardView::Front); }},
      {Qt::Key_3, [](ViewCamera& camera) { camera.look_from(StandardView::Right); }},
      {Qt::Key_7, [](ViewCamera& camera) { camera.look_from(StandardView::Top); }},
      {Qt::Key_9, [](ViewCamera& camera) { camera.look_from_opposite(); }},
      {Qt::Key_5, [](ViewCamera& camera) { camera.set_orthographic(!camera.is_orthographic()); }}};
  ViewCamera camera = camera_;
  if (const QPoint way = arrow_way(key); !way.isNull()) {
    const QPointF step = QPointF(way) * (has_shift ? PanPerKey : OrbitPerKey);
    has_shift ? camera.pan(step.x(), step.y()) : camera.orbit(step.x(), step.y());
  } else if (const auto steps = zooms.find(key); steps != zooms.end()) {
    camera.zoom(std::pow(ZoomPerStep, steps->second), grf::Vec2d(0), aspect);
  } else if (const auto view = views.find(key); view != views.end()) {
    view->second(camera);
  } else {
    return false;
  }
  move(camera);
  return true;
}

bool CameraNavigation::begin_flying(int key) {
  static const std::set<int> keys = {Qt::Key_W, Qt::Key_A, Qt::Key_S, Qt::Key_D, Qt::Key_Q, Qt::Key_E};
  if (!keys.contains(key)) return false;
  flying_keys_.insert(key);
  if (!fly_timer_.isActive()) fly_timer_.start();
  return true;
}

void CameraNavigation::end_flying(int key) {
  flying_keys_.erase(key);
  if (flying_keys_.empty()) fly_timer_.stop();
}

void CameraNavigation::end_flying() {
  flying_keys_.clear();
  fly_timer_.stop();
}

void CameraNavigation::fly() {
  const double step = FlyingSpeed * camera_.distance() * fly_timer_.interval() / 1000;
  const auto along = [&](Qt::Key forwards, Qt::Key backwards) {
    return step * (flying_keys_.contains(forwards) ? 1 : flying_keys_.contains(backwards) ? -1 : 0);
  };
  ViewCamera camera = camera_;
  camera.fly(along(Qt::Key_D, Qt::Key_A), along(Qt::Key_E, Qt::Key_Q), along(Qt::Key_W, Qt::Key_S));
  move(camera);
}

}  // namespace editor
