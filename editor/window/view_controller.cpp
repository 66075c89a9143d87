#include "editor/window/view_controller.h"

#include <QDragMoveEvent>
#include <QDropEvent>
#include <QFileInfo>
#include <QKeyEvent>
#include <QMimeData>
#include <QMouseEvent>
#include <algorithm>
#include <utility>

#include "editor/controls/form_widgets.h"
#include "editor/document/brdf_mime.h"
#include "editor/document/image_files.h"
#include "editor/document/light_edits.h"
#include "editor/document/object_mime.h"
#include "editor/document/object_order.h"
#include "editor/document/scene_places.h"
#include "editor/panels/brdf_assignment.h"
#include "editor/panels/environment_form.h"
#include "editor/panels/texture_row.h"
#include "editor/view/scene_view.h"
#include "editor/window/render_controller.h"

namespace editor {
namespace {

/// The image file among dragged data; empty if there is none.
QString image_in(const QMimeData& data) {
  const QStringList files = local_files(data);
  const auto image = std::ranges::find_if(files, is_image);
  return image == files.end() ? QString() : *image;
}

}  // namespace

ViewController::ViewController(Document& document, const grf::Catalogue& catalogue, SceneView& view,
                               RenderController& render, QObject* parent)
    : QObject(parent), document_(document), catalogue_(catalogue), view_(view), render_(render) {
  view_.setAcceptDrops(true);
  view_.installEventFilter(this);
  connect(&document_, &Document::changed, this, [this] { view_.show(document_.shared_objects()); });
  connect(&document_, &Document::editor_state_changed, this, [this] {
    view_.set_hidden_and_locked(document_.editor_state().hidden, document_.editor_state().locked);
  });
  connect(&document_, &Document::selection_changed, this,
          [this] { view_.set_selection(document_.selection()); });
  connect(&view_, &SceneView::selection_made, &document_, &Document::select);
  connect(&view_, &SceneView::objects_picked, this, &ViewController::select_objects);
  connect(&view_, &SceneView::object_moved, this, &ViewController::move_object);
}

std::optional<grf::Scene> ViewController::scene_with(const HandleId& object, const grf::Vec3d& position,
                                                     grf::Diagnostics& diagnostics) const {
  const SceneObjects& objects = document_.objects();
  if (object.kind == HandleKind::Light) {
    const auto light = std::ranges::find_if(
        objects.lights, [&](const LightObject& each) { return each.path == object.path; });
    if (light == objects.lights.end()) return std::nullopt;
    grf::AreaLight moved = light->light;
    moved.corner = grf::Vec3f(position * light->to_world.inverse());
    return change_light(document_.scene(), object.path, moved, diagnostics);
  }
  const auto observer = std::ranges::find_if(objects.observers, [&](const ObserverObject& each) {
    return each.path == object.path && each.number == object.number;
  });
  if (observer == objects.observers.end()) return std::nullopt;
  return move_observer(document_.scene(), *observer, position, diagnostics);
}

void ViewController::move_object(const HandleId& object, const grf::Vec3d& position) {
  if (object.kind == HandleKind::CameraEye || object.kind == HandleKind::CameraTarget) {
    transport::View camera = render_.camera();
    (object.kind == HandleKind::CameraEye ? camera.eye : camera.target) = position;
    if (camera.eye != camera.target) render_.move_camera(camera);
    return;
  }
  grf::Diagnostics diagnostics;
  auto scene = scene_with(object, position, diagnostics);
  if (scene) {
    document_.replace(object.kind == HandleKind::Light ? tr("Move the light") : tr("Move the observer"),
                      std::move(*scene));
  } else if (diagnostics.error_count() > 0) {
    emit failed(QString::fromStdString(diagnostics.to_text()));
  }
}

/// With Shift the objects are added to the selected ones, with Ctrl removed.
void ViewController::select_objects(const std::vector<grf::ScenePath>& paths,
                                    Qt::KeyboardModifiers modifiers) {
  std::vector<grf::ScenePath> selected;
  if (modifiers & (Qt::ShiftModifier | Qt::ControlModifier)) selected = document_.selected_objects();
  std::erase_if(selected,
                [&paths](const auto& each) { return std::ranges::find(paths, each) != paths.end(); });
  if (!modifiers.testFlag(Qt::ControlModifier)) selected.insert(selected.end(), paths.begin(), paths.end());
  document_.select_objects(std::move(selected));
}

void ViewController::pick(const Pick& pick) {
  pick_ = pick;
  view_.installEventFilter(this);  // before other filters, such as that of a gizmo
  view_.setCursor(Qt::CrossCursor);
  view_.setFocus();
  emit status_message(pick.message);
}

/// Returns whether the pointer is there to pick.
bool ViewController::pick_at(const QPointF& pixel, Qt::MouseButtons buttons) {
  if (!pick_ || !buttons.testFlag(Qt::LeftButton)) return false;
  const auto picked = pick_->picked;
  const std::optional<SurfacePoint> point = view_.surface_at(pixel);
  if (!pick_->follows_drag) end_picking();
  if (point) picked(*point);
  return true;
}

void ViewController::end_picking() {
  const auto finished = std::exchange(pick_, std::nullopt)->finished;
  view_.unsetCursor();
  emit status_message({});
  if (finished) finished();
}

bool ViewController::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::DragEnter:
    case QEvent::DragMove: {
      auto& drag = static_cast<QDragMoveEvent&>(*event);
      if (!image_in(*drag.mimeData()).isEmpty()) {
        drag.acceptProposedAction();
        return true;
      }
      if (!definition_in(*drag.mimeData()).empty()) {
        drag.acceptProposedAction();
        return true;
      }
      if (!drag.mimeData()->hasFormat(BrdfMimeType)) return false;
      const bool is_over_face = view_.face_at(drag.position()).has_value();
      // Qt ignores a drag whose enter event was rejected.
      drag.setAccepted(is_over_face || event->type() == QEvent::DragEnter);
      return true;
    }
    case QEvent::Drop:
      return drop(static_cast<QDropEvent&>(*event));
    case QEvent::MouseButtonPress:
    case QEvent::MouseMove: {
      const auto& pointer = static_cast<QMouseEvent&>(*event);
      return pick_at(pointer.position(), pointer.buttons());
    }
    case QEvent::MouseButtonRelease:
      if (!pick_ || static_cast<QMouseEvent&>(*event).button() != Qt::LeftButton) return false;
      end_picking();
      return true;
    case QEvent::KeyPress:
      if (!pick_ || static_cast<QKeyEvent&>(*event).key() != Qt::Key_Escape) return false;
      end_picking();
      return true;
    default:
      return QObject::eventFilter(watched, event);
  }
}

/// The path of the definition among dragged objects; empty if there is none.
grf::ScenePath ViewController::definition_in(const QMimeData& data) const {
  const std::vector<grf::ScenePath> paths = paths_of(data);
  const bool is_definition = !paths.empty() && definition_at(document_.scene(), paths.front()) != nullptr;
  return is_definition ? paths.front() : grf::ScenePath();
}

/// Adds an instance that stands on the surface under the pointer, or on the floor at the orbit centre.
void ViewController::add_instance(const grf::ScenePath& definition, const QPointF& pixel) {
  const grf::Scene& scene = document_.scene();
  const BlockPlace place = place_at_end(scene, grf::ScenePathView(definition).first(definition.size() - 1));
  grf::Diagnostics diagnostics;
  auto added = use_definition(scene, definition, place, diagnostics);
  if (added) {
    const std::optional<SurfacePoint> surface = view_.surface_at(pixel);
    const grf::Vec3d centre = view_.camera().target();
    added = place_on_surface(added->scene, objects_of(added->scene, document_.path().toStdString()),
                             added->paths, surface ? surface->position : grf::Vec3d(centre.x, 0, centre.z),
                             std::nullopt, diagnostics);
  }
  if (!added) return emit failed(QString::fromStdString(diagnostics.to_text()));
  document_.replace_objects(tr("Add instance"), std::move(*added));
}

/// Assigns to all selected faces if one of them is hit, else only to the face.
bool ViewController::drop(QDropEvent& event) {
  if (const grf::ScenePath definition = definition_in(*event.mimeData()); !definition.empty()) {
    add_instance(definition, event.position());
    event.setDropAction(Qt::CopyAction);
    event.accept();
    return true;
  }
  const QString image = image_in(*event.mimeData());
  if (image.isEmpty() && !event.mimeData()->hasFormat(BrdfMimeType)) return false;
  const std::optional<FaceId> face = view_.face_at(event.position());
  if (face && !document_.selection().has(*face)) {
    FaceSelection only(document_.objects());
    only.set(*face);
    document_.select(std::move(only));
  }
  if (!image.isEmpty()) {
    if (face) {
      assign_texture(document_, image);
      emit texture_dropped();
    } else {
      set_environment(image);
    }
    event.acceptProposedAction();
    return true;
  }
  if (!face) return true;
  grf::Diagnostics diagnostics;
  if (!assign_brdf(document_, catalogue_, *event.mimeData(), diagnostics)) {
    emit failed(QString::fromStdString(diagnostics.to_text()));
  }
  event.acceptProposedAction();
  return true;
}

/// Lights the scene by an image.
void ViewController::set_environment(const QString& image) {
  editor::set_environment(document_.options(), image);
  emit status_message(tr("%1 is the environment now").arg(QFileInfo(image).fileName()));
}

void ViewController::add_observer() {
  document_.replace(tr("Add an observer"), editor::add_observer(document_.scene(), view_.camera().eye()));
}

}  // namespace editor
