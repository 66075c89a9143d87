// How the 3D view finds what is under the pointer and in regions, and selects it.
#include <cmath>
#include <limits>
#include <utility>

#include "editor/document/face_loops.h"
#include "editor/view/region_selection.h"
#include "editor/view/scene_view.h"
#include "editor/view/screen_geometry.h"

namespace editor {
namespace {

grf::Vec2d pixel_vector(const QPointF& point) { return {point.x(), point.y()}; }

/// The corner of a face at which its edge nearest to a pixel begins.
std::uint32_t nearest_edge(const SceneObjects& objects, const SceneHit& hit, const ViewCamera& camera,
                           const grf::Vec2d& size, const grf::Vec2d& pixel) {
  const MeshInstance& instance = (*objects.instances)[hit.instance];
  const grf::Mesh& mesh = *objects.meshes[hit.face.mesh].mesh;
  std::vector<std::optional<grf::Vec2d>> corners;
  for (const std::uint32_t corner : mesh.face(hit.face.face)) {
    const grf::Vec3d position = grf::Vec3d(mesh.geometry->positions[corner]) * instance.to_world;
    corners.push_back(pixel_of(position, camera, size));
  }
  std::uint32_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t i = 0; i < corners.size(); ++i) {
    const auto& from = corners[i];
    const auto& to = corners[(i + 1) % corners.size()];
    if (!from || !to) continue;  // behind the eye
    const double distance = distance_to_line(pixel, *from, *to);
    if (distance < least) {
      nearest = i;
      least = distance;
    }
  }
  return nearest;
}

}  // namespace

// Picking

grf::Vec2d SceneView::place_at(const QPointF& pixel) const {
  return place_of_pixel(pixel_vector(pixel), window_size());
}

std::optional<SceneHit> SceneView::hit_at(const QPointF& pixel) const {
  return intersect(*objects_, geometry_.shapes(), *hidden_, camera().ray(place_at(pixel), aspect()));
}

std::optional<FaceId> SceneView::face_at(const QPointF& pixel) const {
  const std::optional<SceneHit> hit = hit_at(pixel);
  return hit ? std::optional(hit->face) : std::nullopt;
}

std::optional<SurfacePoint> SceneView::surface_at(const QPointF& pixel) const {
  const std::optional<SceneHit> hit = hit_at(pixel);
  if (!hit) return std::nullopt;
  const ViewRay ray = camera().ray(place_at(pixel), aspect());
  return SurfacePoint{hit->face, ray.at(hit->distance), normal_at(*objects_, geometry_.shapes(), ray, *hit),
                      ray.direction};
}

// Selecting

void SceneView::select_region(const QPainterPath& region, Qt::KeyboardModifiers modifiers) {
  ++number_;
  pending_region_ = PendingRegion{number_, objects_, modifiers};
  const bool has_faces = mode() != DisplayMode::Wireframe && mode() != DisplayMode::Points;
  renderer_.select({state(), region, selects_through_ || !has_faces});
}

/// Removes the hidden and locked faces.
void SceneView::remove_unselectable(FaceSelection& faces) const {
  if (!hidden_->empty()) faces.remove(*hidden_);
  if (!locked_.empty()) faces.remove(locked_);
}

void SceneView::take_region(FaceSelection selected, std::int64_t state) {
  if (!pending_region_ || pending_region_->state != state) return;
  const PendingRegion order = *std::exchange(pending_region_, std::nullopt);
  // Nothing is selected if the scene was replaced meanwhile.
  if (order.objects != objects_) return emit region_selected();
  remove_unselectable(selected);
  make_selection(selected, order.modifiers);
  std::vector<grf::ScenePath> picked;
  for (const MeshInstance& instance : *objects_->instances) {
    if (selected.count(instance.mesh) > 0) picked.push_back(instance.path);
  }
  emit objects_picked(picked, order.modifiers);
  emit region_selected();
}

void SceneView::click(const QPointF& pixel, Qt::KeyboardModifiers modifiers) {
  auto hit = hit_at(pixel);
  if (hit && locked_.has(hit->face)) hit.reset();
  FaceSelection made(*objects_);
  if (hit && modifiers.testFlag(Qt::AltModifier)) {
    const std::uint32_t edge = nearest_edge(*objects_, *hit, camera(), window_size(), pixel_vector(pixel));
    made = modifiers.testFlag(Qt::ControlModifier) ? crossing_face_loop(*objects_, hit->face, edge)
                                                   : face_loop(*objects_, hit->face, edge);
    modifiers &= Qt::ShiftModifier;
  } else if (hit) {
    made.set(hit->face);
  }
  remove_unselectable(made);
  // A click on the background with a modifier changes nothing.
  if (!hit && modifiers != Qt::NoModifier) return;
  make_selection(std::move(made), modifiers);
  std::vector<grf::ScenePath> picked;
  if (hit) picked.push_back((*objects_->instances)[hit->instance].path);
  emit objects_picked(picked, modifiers);
}

void SceneView::toggle_middle() {
  const auto hit = hit_at(QPointF(width() / 2.0, height() / 2.0));
  if (!hit || locked_.has(hit->face)) return;
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

}  // namespace editor
