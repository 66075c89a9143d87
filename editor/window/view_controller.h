#pragma once

#include <QObject>
#include <functional>
#include <optional>

#include "editor/document/document.h"
#include "grf/catalogue.h"

class QDropEvent;
class QMimeData;

namespace editor {

class RenderController;
class SceneView;
struct HandleId;
struct SurfacePoint;

/// Connects the 3D view to a document: selection, moving lights, observers and the camera, BRDFs and images
/// dropped on faces, and points that are picked.
class ViewController : public QObject {
  Q_OBJECT

 public:
  /// All outlive it.
  ViewController(Document& document, const grf::Catalogue& catalogue, SceneView& view,
                 RenderController& render, QObject* parent);

  /// Passes the point of the next click to `picked` instead of selecting its face; Escape cancels. The
  /// message says what to click. If it follows a drag, so it gets each of its points, until `finished`.
  struct Pick {
    QString message;
    std::function<void(const SurfacePoint&)> picked;
    std::function<void()> finished = {};
    bool follows_drag = false;
  };
  void pick(const Pick& pick);

  /// Adds an observer at the viewpoint of the 3D view.
  void add_observer();

 signals:
  void failed(const QString& message);
  void status_message(const QString& message);
  void texture_dropped();  ///< on faces, which have it now

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void select_objects(const std::vector<grf::ScenePath>& paths, Qt::KeyboardModifiers modifiers);
  void move_object(const HandleId& object, const grf::Vec3d& position);
  std::optional<grf::Scene> scene_with(const HandleId& object, const grf::Vec3d& position,
                                       grf::Diagnostics& diagnostics) const;
  grf::ScenePath definition_in(const QMimeData& data) const;
  void add_instance(const grf::ScenePath& definition, const QPointF& pixel);
  bool drop(QDropEvent& event);
  void set_environment(const QString& image);
  bool pick_at(const QPointF& pixel, Qt::MouseButtons buttons);
  void end_picking();

  Document& document_;
  const grf::Catalogue& catalogue_;
  SceneView& view_;
  RenderController& render_;
  std::optional<Pick> pick_;
};

}  // namespace editor
