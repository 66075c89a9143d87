#pragma once

#include <QObject>
#include <functional>

#include "editor/document/document.h"
#include "grf/catalogue.h"

class QDropEvent;

namespace editor {

class RenderLink;
class SceneView;
struct HandleId;

/// Lets the 3D view show a document and edit it: selecting, moving lights, observers and the camera, BRDFs
/// that are dropped on faces, and faces that others are to be like.
class ViewLink : public QObject {
  Q_OBJECT

 public:
  /// All outlive it.
  ViewLink(Document& document, const grf::Catalogue& catalogue, SceneView& view, RenderLink& render,
           QObject* parent);

  /// The next click in the view is not to select a face but to be given to this; Escape gives it up.
  void pick_face(const std::function<void(FaceId)>& picked);

  /// Adds an observer where the view is seen from.
  void add_observer();

 signals:
  void failed(const QString& message);
  void told(const QString& message);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void move_object(const HandleId& object, const grf::Vec3d& position);
  std::optional<grf::Scene> scene_with(const HandleId& object, const grf::Vec3d& position,
                                       grf::Diagnostics& diagnostics) const;
  bool drop(QDropEvent& event);
  void end_picking();

  Document& document_;
  const grf::Catalogue& catalogue_;
  SceneView& view_;
  RenderLink& render_;
  std::function<void(FaceId)> picked_;
};

}  // namespace editor
