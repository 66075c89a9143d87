#pragma once

#include <QObject>
#include <QPointF>
#include <QTimer>
#include <set>

#include "editor/view/view_camera.h"

namespace editor {

/// Moves a camera by pointer, wheel and keys. Positions in the image are those of ViewCamera.
class CameraNavigation : public QObject {
  Q_OBJECT

 public:
  enum class Drag { Orbit, Pan, Look };

  CameraNavigation();

  const ViewCamera& camera() const { return camera_; }
  /// Sets the camera, without a signal.
  void set_camera(const ViewCamera& camera) { camera_ = camera; }
  void move(const ViewCamera& camera);

  void begin(Drag drag) { drag_ = drag; }
  /// Drags by so many pixels in an image of that height.
  void drag(const QPointF& way, double height);
  void zoom(double steps, const grf::Vec2d& place, double aspect);
  /// Handles a key press. Returns whether the key moves the camera.
  bool press(int key, bool has_shift, double aspect);

  /// Starts to fly, until the key is released. Returns whether the key is one for flying.
  bool begin_flying(int key);
  void end_flying(int key);
  void end_flying();

 signals:
  void moved();

 private:
  void fly();

  ViewCamera camera_;
  Drag drag_ = Drag::Orbit;
  std::set<int> flying_keys_;
  QTimer fly_timer_;
};

}  // namespace editor
