#pragma once

#include <QObject>
#include <QPointF>
#include <QTimer>
#include <set>

#include "editor/view/view_camera.h"

namespace editor {

/// Moves a camera as the pointer, the wheel and keys ask for. Places in the image are those of ViewCamera.
class CameraNavigation : public QObject {
  Q_OBJECT

 public:
  enum class Drag { Orbit, Pan, Look };

  CameraNavigation();

  const ViewCamera& camera() const { return camera_; }
  /// Without a signal.
  void set_camera(const ViewCamera& camera) { camera_ = camera; }
  void move(const ViewCamera& camera);

  void begin(Drag drag) { drag_ = drag; }
  /// By so many pixels of an image of that height.
  void drag(const QPointF& way, double height);
  void zoom(double steps, const grf::Vec2d& place, double aspect);
  /// Returns whether the key moves the camera.
  bool press(int key, bool has_shift, double aspect);

  /// Flies as long as one of its keys is pressed. Returns whether this is one.
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
