#include "editor/view/scene_view.h"

#include <QEvent>
#include <QOpenGLContext>
#include <QOpenGLVersionFunctionsFactory>
#include <algorithm>

#include "editor/appearance/theme.h"
#include "editor/view/ground_grid.h"
#include "editor/view/scene_view_graphics.h"

namespace editor {
namespace {

/// So long the view has to rest before a picture that takes long is begun, in milliseconds.
constexpr int RestTime = 50;
/// One slice of work on a picture, in seconds: there is time for it beside showing the last one.
constexpr double Slice = 0.012;

bool has_as_many_faces(const SceneObjects& a, const FaceSelection& selection) {
  if (a.meshes.size() != selection.mesh_count()) return false;
  for (std::uint32_t i = 0; i < a.meshes.size(); ++i) {
    if (a.meshes[i].mesh->face_count() != selection.of_mesh(i).size()) return false;
  }
  return true;
}

}  // namespace

SceneView::SceneView(QWidget* parent) : QOpenGLWidget(parent) {
  QSurfaceFormat format;
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  setFormat(format);
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setMinimumSize(160, 120);
  setAccessibleName(tr("3D view"));
  setAccessibleDescription(tr(
      "The scene. Arrow keys orbit, with Shift they pan, plus and minus zoom, Space selects the face in the "
      "middle, F frames the selection, Home frames all, 1, 3, 7 and 9 are standard views, 5 changes "
      "perspective."));
  work_timer_.setSingleShot(true);
  hover_timer_.setSingleShot(true);
  hover_timer_.setInterval(30);
  fly_timer_.setInterval(16);
  connect(&work_timer_, &QTimer::timeout, this, &SceneView::work);
  connect(&hover_timer_, &QTimer::timeout, this, &SceneView::tell_hovered);
  connect(&fly_timer_, &QTimer::timeout, this, &SceneView::fly);
  connect(&geometry_, &GeometryStore::changed, this, [this] {
    is_geometry_loaded_ = false;
    update();
  });
  connect(&textures_, &TextureStore::failed, this, &SceneView::message);
  connect(&textures_, &TextureStore::changed, this, [this] {
    is_scene_loaded_ = false;
    update();
  });
}

SceneView::~SceneView() {
  // The context ends after this: nothing is left then to hear of it.
  if (context() != nullptr) disconnect(context(), nullptr, this, nullptr);
  release_graphics();
}

void SceneView::release_graphics() {
  if (graphics_ == nullptr) return;
  makeCurrent();
  graphics_.reset();
  doneCurrent();
}

void SceneView::show(const SceneObjects& objects) {
  cancel_gesture();
  objects_ = objects;
  if (!has_as_many_faces(objects_, selection_)) selection_ = FaceSelection(objects_);
  geometry_.set_objects(objects_);
  std::vector<std::string> paths;
  for (const MeshObject& mesh : objects_.meshes) {
    for (const Look& look : mesh.looks) {
      if (!look.texture.empty()) paths.push_back(look.texture);
    }
  }
  textures_.set_paths(paths);
  is_scene_loaded_ = false;
  is_geometry_loaded_ = false;
  place_handles();
  // Not at once: between an edit and its picture there is a turn for the pointer and the keyboard.
  QTimer::singleShot(0, this, [this] { update(); });
}

void SceneView::set_selection(const FaceSelection& selection) {
  selection_ = selection;
  if (graphics_ != nullptr && is_scene_loaded_) {
    makeCurrent();
    graphics_->scene.set_selection(selection_);
    doneCurrent();
  }
  update();
}

void SceneView::set_camera(const ViewCamera& camera) {
  camera_ = camera;
  update();
}

void SceneView::move_camera(const ViewCamera& camera) {
  if (camera == camera_) return;
  set_camera(camera);
  emit camera_moved();
}

void SceneView::frame_all() {
  ViewCamera camera = camera_;
  camera.frame(objects_.bounds, aspect());
  move_camera(camera);
}

void SceneView::frame_selection() {
  if (selection_.empty()) return frame_all();
  grf::Box3d box;
  for (const MeshInstance& instance : objects_.instances) {
    const grf::Mesh& mesh = *objects_.meshes[instance.mesh].mesh;
    const std::vector<bool>& faces = selection_.of_mesh(instance.mesh);
    for (std::size_t face = 0; face < faces.size(); ++face) {
      if (!faces[face]) continue;
      for (const std::uint32_t corner : mesh.face(face)) {
        box.extendBy(grf::Vec3d(mesh.positions[corner]) * instance.to_world);
      }
    }
  }
  ViewCamera camera = camera_;
  camera.frame(box, aspect());
  move_camera(camera);
}

void SceneView::set_mode(DisplayMode mode) {
  mode_ = mode;
  is_scene_loaded_ = false;
  update();
}

void SceneView::set_vertex_normals(bool are_shown) {
  has_vertex_normals_ = are_shown;
  update();
}

void SceneView::set_face_normals(bool are_shown) {
  has_face_normals_ = are_shown;
  update();
}

void SceneView::set_grid(bool is_shown) {
  has_grid_ = is_shown;
  update();
}

void SceneView::set_render_camera(const std::optional<transport::View>& camera, double image_aspect) {
  render_camera_ = camera;
  render_aspect_ = image_aspect;
  place_handles();
  update();
}

void SceneView::place_handles() {
  const double size = objects_.bounds.isEmpty() ? 0.2 : objects_.bounds.size().length() / 30;
  handles_ = handles_of(objects_, render_camera_, render_aspect_, std::max(size, 1e-6));
}

bool SceneView::is_full() const {
  return graphics_ != nullptr && is_scene_loaded_ && is_full_on_screen_ && geometry_.has_all_meshes() &&
         textures_.is_complete() && graphics_->pictures.is_of(request(), picture_size());
}

bool SceneView::is_complete() const {
  return is_full() && is_geometry_loaded_ && geometry_.is_complete() && graphics_->pictures.is_done();
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
  grf::Box3d box = objects_.bounds;
  for (const SceneHandle& handle : handles_) {
    for (const auto& [from, to] : handle.lines) {
      box.extendBy(from);
      box.extendBy(to);
    }
  }
  if (has_grid_) {
    const GroundGrid grid = ground_grid(objects_.bounds);
    box.extendBy(grf::Vec3d(-grid.half_size, 0, -grid.half_size));
    box.extendBy(grf::Vec3d(grid.half_size, 0, grid.half_size));
  }
  return box;
}

void SceneView::initializeGL() {
  graphics_.reset();
  connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &SceneView::release_graphics,
          Qt::UniqueConnection);
  auto* gl = QOpenGLVersionFunctionsFactory::get<Gl>(context());
  if (gl == nullptr) {
    emit message(tr("The 3D view needs OpenGL 3.3, which this screen has not."));
    return;
  }
  gl->initializeOpenGLFunctions();
  graphics_ = std::make_unique<Graphics>(*gl);
  is_scene_loaded_ = false;
  is_geometry_loaded_ = false;
}

void SceneView::load_scene() {
  SceneBuffers& scene = graphics_->scene;
  if (is_scene_loaded_ && is_geometry_loaded_) return;
  if (!is_scene_loaded_) {
    scene.set_objects(objects_);
    scene.set_selection(selection_);
    textures_.for_each(
        [&](const std::string& path, const transport::Image* image) { scene.set_texture(path, image); });
    if (mode_ == DisplayMode::Brdf && !scene.tables().not_shown.empty()) {
      emit message(tr("Shown as matte: %1.").arg(QString::fromStdString(*scene.tables().not_shown.begin())));
    }
  }
  const bool has_other_meshes = scene.set_geometry(geometry_);
  if (has_other_meshes || !is_scene_loaded_) graphics_->pictures.invalidate();
  graphics_->pictures.invalidate_quick();
  is_scene_loaded_ = true;
  is_geometry_loaded_ = true;
}

void SceneView::resizeGL(int, int) { update(); }

void SceneView::paintGL() {
  if (graphics_ == nullptr) return;
  load_scene();
  ViewPictures& pictures = graphics_->pictures;
  pictures.request(request(), picture_size());
  pictures.prepare();
  compose();
  draw_overlay();
  is_full_on_screen_ = pictures.is_full();
  // While the pointer turns a heavy scene, all time is for quick pictures.
  if (!pictures.is_done()) work_timer_.start(pictures.is_slow() && !pictures.is_full() ? RestTime : 0);
}

void SceneView::work() {
  if (graphics_ == nullptr || !isVisible()) return;
  makeCurrent();
  const bool has_news = graphics_->pictures.work(Slice);
  const bool is_done = graphics_->pictures.is_done();
  doneCurrent();
  if (has_news) {
    update();
  } else if (!is_done) {
    work_timer_.start(0);
  }
}

void SceneView::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) update();
  QOpenGLWidget::changeEvent(event);
}

}  // namespace editor
