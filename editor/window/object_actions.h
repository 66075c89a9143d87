#pragma once

#include <QList>
#include <QObject>
#include <functional>
#include <optional>

#include "editor/document/document.h"
#include "editor/document/primitive_shapes.h"

class QAction;
class QActionGroup;
class QMenu;
class QToolBar;
class QWidget;

namespace editor {

class GizmoInput;
class SceneView;

/// Actions that add primitive shapes, and place the selected objects: gizmos, gestures by keys, pivot and
/// axes, alignment.
class ObjectActions : public QObject {
  Q_OBJECT

 public:
  ObjectActions(Document& document, SceneView& view, QWidget& window);

  void fill(QMenu& menu);
  void fill(QToolBar& bar);
  /// The actions that add a primitive shape or a studio.
  const QList<QAction*>& additions() const { return additions_; }
  /// Adds a floor and two lights in proportion to the scene.
  void add_studio();

  /// Places the selected objects on a point of a surface, see `place_on_surface`.
  void place_on(const grf::Vec3d& point, const std::optional<grf::Vec3d>& normal);

 signals:
  /// Emitted when the point of a surface shall be picked on which the selected objects are placed: along its
  /// normal or upright.
  void surface_requested(bool is_along_normal);
  void status_message(const QString& text);
  /// Emitted after a shape was added and selected, with its parameters.
  void shape_added(const editor::PrimitiveShape& shape);

 private:
  using Kind = grf::TransformStep::Kind;
  using Edit = std::function<std::optional<TransformedObjects>(grf::Diagnostics& diagnostics)>;

  void make_additions();
  void add_shape(PrimitiveShape::Kind kind);
  void make_gizmos();
  void make_gestures();
  void make_options();
  void make_placements();
  QAction* add_placement(const QString& text, const QKeySequence& keys, const QString& tip, const Edit& made);
  void make_structure();
  void make_moves();
  void make_alignments();
  void update_target();
  void apply(const TransformAction& action);
  void edit(const QString& text, const Edit& made);
  void mirror(int axis);

  Document& document_;
  SceneView& view_;
  QWidget& window_;
  GizmoInput* gizmo_;
  PivotPoint pivot_ = PivotPoint::Centre;
  bool is_local_ = false;
  QActionGroup* gizmos_;
  QList<QAction*> additions_, gestures_, pivots_, options_, placements_, structure_, moves_, mirrors_,
      alignments_;
};

}  // namespace editor
