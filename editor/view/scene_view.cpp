#include "editor/view/scene_view.h"

#include <QEvent>
#include <QPainter>
#include <algorithm>
#include <utility>

#include "editor/appearance/theme.h"
#include "editor/view/ground_grid.h"

namespace editor {
namespace {

bool has_as_many_faces(const SceneObjects& a, const FaceSelection& selection) {
  if (a.meshes.size() != selection.mesh_count()) return false;
  for (std::uint32_t i = 0; i < a.meshes.size(); ++i) {
    if (a.meshes[i].mesh->face_count() != selection.of_mesh(i).size()) return false;
  }
  return true;
}

}  // namespace

SceneView::SceneView(QWidget* parent, const GraphicsDriver& driver, const ImageProcess& images)
    : QWidget(parent),
      objects_(std::make_shared<const SceneObjects>()),
      selection_(std::make_shared<const FaceSelection>()),
      textures_(images),
      renderer_(driver) {
  setAttribute(Qt::WA_OpaquePaintEvent);
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setMinimumSize(160, 120);
  setAccessibleName(tr("3D view"));
  setAccessibleDescription(tr(
      "The scene. Arrow keys orbit, with Shift they pan, plus and minus zoom, Space selects the face in the "
      "middle, F frames the selection, Home frames all, 1, 3, 7 and 9 are standard views, 5 changes "
      "perspective."));
  hover_timer_.setSingleShot(true);
  hover_timer_.setInterval(30);
  fly_timer_.setInterval(16);
  connect(&hover_timer_, &QTimer::timeout, this, &SceneView::tell_hovered);
  connect(&fly_timer_, &QTimer::timeout, this, &SceneView::fly);
  connect(&geometry_, &GeometryStore::changed, this, &SceneView::draw);
  connect(&textures_, &TextureStore::failed, this, &SceneView::message);
  connect(&textures_, &TextureStore::changed, this, &SceneView::draw);
  connect(&renderer_, &ViewRenderer::drawn, this, &SceneView::take_image);
  connect(&renderer_, &ViewRenderer::selected, this, &SceneView::take_region);
  connect(&renderer_, &ViewRenderer::message, this, &SceneView::message);
  connect(&renderer_, &ViewRenderer::warned, this, &SceneView::warned);
}

void SceneView::show(std::shared_ptr<const SceneObjects> objects) {
  cancel_gesture();
  objects_ = std::move(objects);
  if (!has_as_many_faces(*objects_, *selection_)) {
    selection_ = std::make_shared<const FaceSelection>(*objects_);
  }
  geometry_.set_objects(*objects_);
  std::vector<std::string> paths;
  for (const MeshObject& mesh : objects_->meshes) {
    for (const Look& look : mesh.looks) {
      if (!look.texture.empty()) paths.push_back(look.texture);
    }
  }
  textures_.set_paths(paths);
  place_handles();
  draw();
}

void SceneView::set_selection(const FaceSelection& selection) {
  selection_ = std::make_shared<const FaceSelection>(selection);
  draw();
}

void SceneView::set_camera(const ViewCamera& camera) {
  camera_ = camera;
  draw();
}

void SceneView::move_camera(const ViewCamera& camera) {
  if (camera == camera_) return;
  set_camera(camera);
  emit camera_moved();
}

void SceneView::frame_all() {
  ViewCamera camera = camera_;
  camera.frame(objects_->bounds, aspect());
  move_camera(camera);
}

void SceneView::frame_selection() {
  if (selection_->empty()) return frame_all();
  grf::Box3d box;
  for (const MeshInstance& instance : *objects_->instances) {
    const grf::Mesh& mesh = *objects_->meshes[instance.mesh].mesh;
    selection_->for_each_face(instance.mesh, [&](std::size_t face) {
      for (const std::uint32_t corner : mesh.face(face)) {
        box.extendBy(grf::Vec3d(mesh.geometry->positions[corner]) * instance.to_world);
      }
    });
  }
  ViewCamera camera = camera_;
  camera.frame(box, aspect());
  move_camera(camera);
}

void SceneView::set_mode(DisplayMode mode) {
  mode_ = mode;
  draw();
}

void SceneView::set_vertex_normals(bool are_shown) {
  has_vertex_normals_ = are_shown;
  draw();
}

void SceneView::set_face_normals(bool are_shown) {
  has_face_normals_ = are_shown;
  draw();
}

void SceneView::set_grid(bool is_shown) {
  has_grid_ = is_shown;
  draw();
}

void SceneView::set_render_camera(const std::optional<transport::View>& camera, double image_aspect) {
  render_camera_ = camera;
  render_aspect_ = image_aspect;
  place_handles();
  draw();
}

void SceneView::place_handles() {
  const double size = objects_->bounds.isEmpty() ? 0.2 : objects_->bounds.size().length() / 30;
  handles_ = handles_of(*objects_, render_camera_, render_aspect_, std::max(size, 1e-6));
}

bool SceneView::is_full() const {
  return shown_.is_full && shown_.state == number_ && geometry_.has_all_meshes() && textures_.is_complete();
}

bool SceneView::is_complete() const {
  return is_full() && shown_.is_done && geometry_.is_complete() && !is_selecting();
}

double SceneView::aspect() const { return window_size().x / window_size().y; }

grf::Vec2d SceneView::window_size() const {
  return {double(std::max(width(), 1)), double(std::max(height(), 1))};
}

ViewStyle SceneView::style() const {
  const Theme theme = theme_of(palette());
  ViewStyle style;
  style.mode = mode_;
  style.has_vertex_normals = has_vertex_normals_;
  style.has_face_normals = has_face_normals_;
  style.lines = colours_of(theme).text;
  style.normals = series_colour(theme, 1);
  style.pixel_ratio = static_cast<float>(devicePixelRatioF());
  return style;
}

PictureRequest SceneView::request() const {
  PictureRequest request;
  request.camera = camera_;
  request.bounds = drawn_bounds();
  request.style = style();
  request.aspect = aspect();
  return request;
}

QSize SceneView::picture_size() const {
  const double ratio = devicePixelRatioF();
  return {std::max(1, qRound(width() * ratio)), std::max(1, qRound(height() * ratio))};
}

/// All that has a depth: the scene, its lights and the grid.
grf::Box3d SceneView::drawn_bounds() const {
  grf::Box3d box = objects_->bounds;
  for (const SceneHandle& handle : handles_) {
    for (const auto& [from, to] : handle.lines) {
      box.extendBy(from);
      box.extendBy(to);
    }
  }
  if (has_grid_) {
    const GroundGrid grid = ground_grid(objects_->bounds);
    box.extendBy(grf::Vec3d(-grid.half_size, 0, -grid.half_size));
    box.extendBy(grf::Vec3d(grid.half_size, 0, grid.half_size));
  }
  return box;
}

void SceneView::draw() {
  ++number_;
  if (is_ordered_ || !isVisible()) return;
  // Of all changes of one turn of the event loop there is one picture.
  is_ordered_ = true;
  QMetaObject::invokeMethod(
      this,
      [this] {
        is_ordered_ = false;
        if (isVisible()) renderer_.show(state());
      },
      Qt::QueuedConnection);
}

ViewState SceneView::state() const {
  ViewState state;
  state.number = number_;
  state.objects = objects_;
  state.selection = selection_;
  state.shapes = geometry_.shapes();
  state.textures = textures_.textures();
  state.request = request();
  state.size = picture_size();
  state.screen = {window_size(), devicePixelRatioF()};
  state.colours = colours();
  state.overlay = overlay();
  return state;
}

void SceneView::take_image(const ViewImage& image) {
  shown_ = image;
  update();
}

void SceneView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (shown_.image.size() == picture_size()) {
    painter.drawImage(0, 0, shown_.image);
  } else {
    // In the middle, until that of this size comes.
    const QSizeF size = shown_.image.deviceIndependentSize();
    paint_background(painter);
    painter.drawImage(QPointF((width() - size.width()) / 2, (height() - size.height()) / 2), shown_.image);
  }
  paint_gesture(painter);
  // The window may have gone to a screen of other pixels.
  if (!shown_.image.isNull() && shown_.image.devicePixelRatio() != devicePixelRatioF()) draw();
}

void SceneView::resizeEvent(QResizeEvent*) { draw(); }
void SceneView::showEvent(QShowEvent*) { draw(); }

void SceneView::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) draw();
  QWidget::changeEvent(event);
}

}  // namespace editor
