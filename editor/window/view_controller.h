#pragma once

#include <QObject>
#include <functional>

#include "editor/document/document.h"
#include "grf/catalogue.h"

class QDropEvent;

namespace editor {

class RenderController;
class SceneView;
struct HandleId;

/// Connects the 3D view to a document: selection, moving lights, observers and the camera, BRDFs dropped on
/// faces, and copying the surface of a picked face.
class ViewController : public QObject {
  Q_OBJECT

 public:
  /// All outlive it.
  ViewController(Document& document, const grf::Catalogue& catalogue, SceneView& view,
                 RenderController& render, QObject* parent);

  /// Passes the next clicked face to `picked` instead of selecting it; Escape cancels.
  void pick_face(const std::function<void(FaceId)>& picked);

  /// Adds an observer at the viewpoint of the 3D view.
  void add_observer();

 signals:
  void failed(const QString& message);
  void status_message(const QString& message);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void select_objects(const std::vector<grf::ScenePath>& paths, Qt::KeyboardModifiers modifiers);
  void move_object(const HandleId& object, const grf::Vec3d& position);
  std::optional<grf::Scene> scene_with(const HandleId& object, const grf::Vec3d& position,
                                       grf::Diagnostics& diagnostics) const;
  bool drop(QDropEvent& event);
  void end_picking();

  Document& document_;
  const grf::Catalogue& catalogue_;
  SceneView& view_;
  RenderController& render_;
  std::function<void(FaceId)> picked_;
};

}  // namespace editor
