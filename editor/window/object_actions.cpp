#include "editor/window/object_actions.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QToolBar>

#include "editor/controls/actions.h"
#include "editor/document/apply_transforms.h"
#include "editor/document/object_edits.h"
#include "editor/document/object_order.h"
#include "editor/document/studio.h"
#include "editor/view/gizmo_input.h"
#include "editor/view/scene_view.h"
#include "editor/view/view_overlay.h"

namespace editor {
namespace {

const QStringList AxisNames = {QStringLiteral("X"), QStringLiteral("Y"), QStringLiteral("Z")};

}  // namespace

ObjectActions::ObjectActions(Document& document, SceneView& view, QWidget& window)
    : QObject(&window),
      document_(document),
      view_(view),
      window_(window),
      gizmo_(new GizmoInput(view)),
      gizmos_(new QActionGroup(this)) {
  make_additions();
  make_gizmos();
  make_gestures();
  make_options();
  make_placements();
  make_structure();
  make_moves();
  make_alignments();
  connect(gizmo_, &GizmoInput::transform_made, this, &ObjectActions::apply);
  connect(gizmo_, &GizmoInput::status_message, this, &ObjectActions::status_message);
  // Bounds of large meshes take long, and an edit of surfaces moves nothing.
  connect(&document_, &Document::changed, this, [this](const Change& change) {
    if (change.moves_objects()) update_target();
  });
  connect(&document_, &Document::selected_objects_changed, this, &ObjectActions::update_target);
  update_target();
}

void ObjectActions::make_additions() {
  using Shape = PrimitiveShape::Kind;
  const auto add = [this](Shape kind, const QString& text, const QString& tip) {
    additions_.append(new_action(window_, {text, {}, {}, tip}, [this, kind] { add_shape(kind); }));
  };
  add(Shape::Plane, tr("Add a &plane"), tr("Add a square that faces up, on the floor at the orbit centre"));
  add(Shape::Box, tr("Add a &box"), tr("Add a cube on the floor at the orbit centre"));
  add(Shape::Sphere, tr("Add a &sphere"), tr("Add a sphere on the floor at the orbit centre"));
  add(Shape::Cylinder, tr("Add a c&ylinder"), tr("Add a closed cylinder on the floor at the orbit centre"));
  add(Shape::Disc, tr("Add a &disc"), tr("Add a disc that faces up, on the floor at the orbit centre"));
  add(Shape::Torus, tr("Add a &torus"), tr("Add a torus on the floor at the orbit centre"));
  additions_.append(new_action(
      window_,
      {tr("Add a st&udio"), {}, {}, tr("Add a floor, a soft box and a rim light in proportion to the scene")},
      [this] { add_studio(); }));
}

void ObjectActions::add_studio() {
  document_.replace(tr("Add studio"), editor::add_studio(document_.scene(), document_.objects()));
}

void ObjectActions::add_shape(PrimitiveShape::Kind kind) {
  const SceneObjects& objects = document_.objects();
  const grf::Vec3d centre = view_.camera().target();
  const PrimitiveShape shape = shape_of_size(kind, proportionate_size(objects.mesh_bounds));
  document_.replace_objects(tr("Add %1").arg(QString::fromUtf8(name_of(kind).data())),
                            add_mesh(document_.scene(), objects, mesh_of(shape), {centre.x, 0, centre.z}));
  emit shape_added(shape);
}

void ObjectActions::make_gizmos() {
  gizmos_->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
  const auto add = [this](const QString& text, const QString& icon, const QKeySequence& keys, Kind kind,
                          const QString& tip) {
    QAction* action = new_switch(window_, {text, icon, keys, tip}, false, [this, kind](bool is_on) {
      if (is_on || gizmo_->gesture().tool() == kind)
        gizmo_->set_tool(is_on ? std::optional(kind) : std::nullopt);
    });
    gizmos_->addAction(action);
    return action;
  };
  add(tr("Mo&ve gizmo"), "move", QKeySequence("Shift+G"), Kind::Translation,
      tr("Show arrows that move the selected objects along axes and in planes"))
      ->setChecked(true);
  add(tr("Rota&te gizmo"), "rotate", QKeySequence("Shift+R"), Kind::Rotation,
      tr("Show rings that rotate the selected objects"));
  add(tr("S&cale gizmo"), "scale", QKeySequence("Shift+S"), Kind::Scale,
      tr("Show handles that scale the selected objects"));
}

void ObjectActions::make_gestures() {
  // Letters are shortcuts only in the view, since fields and lists need them for typing.
  const auto add = [this](const QString& text, Qt::Key key, Kind kind, const QString& tip) {
    QAction* action = new_action(window_, {text, {}, key, tip}, [this, kind] { gizmo_->begin(kind); });
    window_.removeAction(action);
    action->setShortcutContext(Qt::WidgetShortcut);
    view_.addAction(action);
    gestures_.append(action);
  };
  add(tr("&Move"), Qt::Key_G, Kind::Translation,
      tr("Move the selected objects with the pointer; X, Y, Z choose an axis, digits the distance"));
  add(tr("&Rotate"), Qt::Key_R, Kind::Rotation,
      tr("Rotate the selected objects with the pointer; X, Y, Z choose an axis, digits the degrees"));
  add(tr("&Scale"), Qt::Key_S, Kind::Scale,
      tr("Scale the selected objects with the pointer; X, Y, Z choose an axis, digits the factor"));
}

void ObjectActions::make_options() {
  auto* group = new QActionGroup(this);
  const auto add = [&](const QString& text, PivotPoint point, const QString& tip) {
    pivots_.append(
        group->addAction(new_switch(window_, {text, {}, {}, tip}, point == pivot_, [this, point](bool is_on) {
          if (!is_on) return;
          pivot_ = point;
          update_target();
        })));
  };
  add(tr("&Centre"), PivotPoint::Centre, tr("Rotate and scale about the centre of the selected objects"));
  add(tr("&Origin"), PivotPoint::Origin,
      tr("Rotate and scale about the origins of the selected objects' transforms"));
  add(tr("&Active object"), PivotPoint::Active, tr("Rotate and scale about the origin of the last object"));
  add(tr("&World origin"), PivotPoint::World, tr("Rotate and scale about the origin of the world"));
  options_ = {new_switch(window_,
                         {tr("Local a&xes"),
                          {},
                          QKeySequence("Ctrl+Alt+O"),
                          tr("Move, rotate and scale along the axes of the object instead of the world")},
                         is_local_,
                         [this](bool is_on) {
                           is_local_ = is_on;
                           update_target();
                         }),
              new_switch(window_,
                         {tr("Sn&ap"), "snap", QKeySequence("Ctrl+Alt+S"),
                          tr("Snap to the grid, to 5° and to factors of 0.1; Ctrl inverts it")},
                         false, [this](bool is_on) { gizmo_->set_snapping(is_on); })};
}

QAction* ObjectActions::add_placement(const QString& text, const QKeySequence& keys, const QString& tip,
                                      const Edit& made) {
  QString title = text;
  title.remove('&');
  return new_action(window_, {text, {}, keys, tip}, [this, title, made] { edit(title, made); });
}

void ObjectActions::make_placements() {
  placements_ = {
      add_placement(tr("&Drop to floor"), QKeySequence("Ctrl+Shift+F"),
                    tr("Move the selected objects vertically so that they stand on the floor, y = 0"),
                    [this](grf::Diagnostics& diagnostics) {
                      return drop_to_floor(document_.scene(), document_.objects(),
                                           document_.selected_objects(), diagnostics);
                    }),
      add_placement(tr("R&eset transform"), QKeySequence("Ctrl+Alt+R"),
                    tr("Remove position, rotation and scale of the selected objects"),
                    [this](grf::Diagnostics& diagnostics) {
                      return reset_transforms(document_.scene(), document_.selected_objects(), diagnostics);
                    }),
      add_placement(tr("Apply trans&form"), {},
                    tr("Apply position, rotation and scale of the selected objects to their vertices"),
                    [this](grf::Diagnostics& diagnostics) {
                      return apply_transforms(document_.scene(), document_.selected_objects(), diagnostics);
                    })};
  placements_ +=
      {new_action(window_,
                  {tr("Place on a s&urface…"),
                   {},
                   QKeySequence("Ctrl+Shift+P"),
                   tr("Click the point of a surface on which the selected objects shall stand")},
                  [this] { emit surface_requested(false); }),
       new_action(window_,
                  {tr("Place along a norma&l…"),
                   {},
                   {},
                   tr("Click the point of a surface on which the selected objects shall stand, along its "
                      "normal")},
                  [this] { emit surface_requested(true); })};
  for (int axis = 0; axis < 3; ++axis) {
    mirrors_.append(new_action(window_,
                               {tr("Along &%1").arg(AxisNames[axis]),
                                {},
                                {},
                                tr("Mirror the selected objects along %1 at the pivot").arg(AxisNames[axis])},
                               [this, axis] { mirror(axis); }));
  }
}

void ObjectActions::make_structure() {
  structure_ = {
      add_placement(tr("&Group"), QKeySequence("Ctrl+G"),
                    tr("Group the selected objects in a transform, beside the last one"),
                    [this](grf::Diagnostics& diagnostics) {
                      return group_objects(document_.scene(), document_.selected_objects(), diagnostics);
                    }),
      add_placement(tr("U&ngroup"), QKeySequence("Ctrl+Shift+G"),
                    tr("Replace the selected groups by their objects, which stay where they are"),
                    [this](grf::Diagnostics& diagnostics) {
                      return ungroup_objects(document_.scene(), document_.selected_objects(), diagnostics);
                    }),
      add_placement(tr("Ma&ke single"), {}, tr("Turn the selected instances into meshes of their own"),
                    [this](grf::Diagnostics& diagnostics) {
                      return make_single(document_.scene(), document_.selected_objects(), diagnostics);
                    }),
      add_placement(tr("Make &instance"), {},
                    tr("Turn the last of the selected meshes into a definition and an instance of it"),
                    [this](grf::Diagnostics& diagnostics) {
                      return make_instance(document_.scene(), document_.selected_objects().back(),
                                           diagnostics);
                    })};
}

void ObjectActions::make_moves() {
  const auto shift = [this](int step) {
    return [this, step](grf::Diagnostics&) {
      return std::optional(shift_objects(document_.scene(), document_.selected_objects(), step));
    };
  };
  moves_ = {
      add_placement(tr("Move up in the list"), QKeySequence("Alt+Up"),
                    tr("Move the selected objects up by one place in the list of the scene"), shift(-1)),
      add_placement(tr("Move down in the list"), QKeySequence("Alt+Down"),
                    tr("Move the selected objects down by one place in the list of the scene"), shift(1)),
      add_placement(tr("Move out of the group"), QKeySequence("Alt+Left"),
                    tr("Move the selected objects out of their group, behind it; they stay in place"),
                    [this](grf::Diagnostics& diagnostics) {
                      return move_out_of_group(document_.scene(), document_.selected_objects(), diagnostics);
                    }),
      add_placement(tr("Move into the group above"), QKeySequence("Alt+Right"),
                    tr("Move the selected objects into the group above them in the list; they stay in "
                       "place"),
                    [this](grf::Diagnostics& diagnostics) {
                      return move_into_group(document_.scene(), document_.selected_objects(), diagnostics);
                    })};
}

void ObjectActions::make_alignments() {
  const auto add = [this](int axis, Alignment alignment, const QString& what) {
    alignments_.append(add_placement(
        tr("Align %1 %2").arg(AxisNames[axis], what), {},
        tr("Move the selected objects along %1 to the %2 of the last one").arg(AxisNames[axis], what),
        [this, axis, alignment](grf::Diagnostics& diagnostics) {
          return align_objects(document_.scene(), document_.objects(), document_.selected_objects(), axis,
                               alignment, diagnostics);
        }));
  };
  for (int axis = 0; axis < 3; ++axis) {
    add(axis, Alignment::Minimum, tr("minimum"));
    add(axis, Alignment::Centre, tr("centre"));
    add(axis, Alignment::Maximum, tr("maximum"));
    alignments_.append(
        add_placement(tr("Distribute along %1").arg(AxisNames[axis]), {},
                      tr("Space the centres of the selected objects evenly along %1").arg(AxisNames[axis]),
                      [this, axis](grf::Diagnostics& diagnostics) {
                        return distribute_objects(document_.scene(), document_.objects(),
                                                  document_.selected_objects(), axis, diagnostics);
                      }));
  }
}

void ObjectActions::update_target() {
  const std::vector<grf::ScenePath>& selected = document_.selected_objects();
  const bool has_objects = !selected.empty();
  for (QAction* action : gestures_ + placements_ + structure_ + moves_ + mirrors_ + alignments_)
    action->setEnabled(has_objects);
  if (!has_objects) return gizmo_->set_target(std::nullopt);
  GizmoTarget target;
  target.blocks = moved_blocks(document_.scene(), selected);
  target.pivot = pivot_of(document_.scene(), document_.objects(), selected, pivot_);
  target.local_axes = object_axes(document_.scene(), selected.back());
  target.is_local = is_local_;
  target.grid_step = ground_grid(document_.objects().bounds).step;
  gizmo_->set_target(std::move(target));
}

void ObjectActions::apply(const TransformAction& action) {
  const QString text = action.kind == Kind::Translation ? tr("Move")
                       : action.kind == Kind::Rotation  ? tr("Rotate")
                                                        : tr("Scale");
  if (!document_.transform_selected(text, action)) view_.show_moved(nullptr);
}

void ObjectActions::edit(const QString& text, const Edit& made) {
  grf::Diagnostics diagnostics;
  auto edited = made(diagnostics);
  if (edited) {
    document_.replace_objects(text, std::move(*edited));
  } else if (diagnostics.error_count() > 0) {
    emit status_message(QString::fromStdString(diagnostics.entries().front().message));
  }
}

void ObjectActions::place_on(const grf::Vec3d& point, const std::optional<grf::Vec3d>& normal) {
  edit(tr("Place on surface"), [&](grf::Diagnostics& diagnostics) {
    return place_on_surface(document_.scene(), document_.objects(), document_.selected_objects(), point,
                            normal, diagnostics);
  });
}

void ObjectActions::mirror(int axis) {
  TransformAction action;
  action.kind = Kind::Scale;
  action.value = grf::Vec3d(1);
  action.value[axis] = -1;
  action.pivot = gizmo_->gesture().target()->pivot;
  if (is_local_) action.axes = gizmo_->gesture().target()->local_axes;
  document_.transform_selected(tr("Mirror"), action);
}

void ObjectActions::fill(QMenu& menu) {
  const auto add_menu = [&menu](const QString& title, const QList<QAction*>& actions) {
    QMenu* child = menu.addMenu(title);
    child->setToolTipsVisible(true);
    child->addActions(actions);
  };
  menu.addActions(gestures_);
  menu.addSeparator();
  menu.addActions(gizmos_->actions());
  add_menu(tr("&Pivot"), pivots_);
  menu.addActions(options_);
  menu.addSeparator();
  menu.addActions(structure_);
  add_menu(tr("Order in the list"), moves_);
  menu.addSeparator();
  menu.addActions(placements_);
  add_menu(tr("Mirr&or"), mirrors_);
  add_menu(tr("Align and distri&bute"), alignments_);
}

void ObjectActions::fill(QToolBar& bar) {
  bar.addActions(gizmos_->actions());
  bar.addAction(options_.back());
}

}  // namespace editor
