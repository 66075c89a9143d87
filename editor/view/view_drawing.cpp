#include "editor/view/view_drawing.h"

#include <QCoreApplication>
#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <utility>

namespace editor {
namespace {

/// Seconds; a slower full image waits for the view to rest.
constexpr double QuickEnough = 0.03;
/// Seconds of a draft: above and below, the next one has fewer or more pixels.
constexpr double TooLong = 0.02;
constexpr double Short = 0.007;
constexpr int LargestScale = 4;
/// Opacity of the accent on selected faces.
constexpr float AccentFill = 0.45F;

bool is_same(const FrameRequest& a, const FrameRequest& b) {
  const bool shows_environment = a.style.mode == DisplayMode::Brdf;
  return a.camera == b.camera && a.bounds == b.bounds && a.style == b.style && a.aspect == b.aspect &&
         (!shows_environment || a.environment == b.environment);
}

double seconds(const QElapsedTimer& clock) { return static_cast<double>(clock.nsecsElapsed()) * 1e-9; }

QVector3D rgb(const QColor& colour) { return {colour.redF(), colour.greenF(), colour.blueF()}; }

/// Reduces the resolution if a side exceeds the limit.
ViewState with_sides_up_to(ViewState state, int most) {
  const int side = std::max(state.size.width(), state.size.height());
  if (side <= most) return state;
  const double scale = static_cast<double>(most) / side;
  state.size = state.size.scaled(most, most, Qt::KeepAspectRatio).expandedTo({1, 1});
  state.screen.pixel_ratio *= scale;
  state.request.style.pixel_ratio *= static_cast<float>(scale);
  return state;
}

}  // namespace

ViewDrawing::ViewDrawing(Gl& gl, const GraphicsDriver& driver)
    : gl_(gl),
      limits_(driver.limits()),
      scene_(gl, limits_),
      renderer_(gl, driver),
      overlay_(gl, driver),
      no_vertices_(gl, GlKind::VertexArray),
      accumulate_(program_of(driver, "screen.vert", {"g_buffer.glsl", "accumulate.frag"})) {
  for (const bool has_map : {false, true}) {
    compose_[has_map ? 1 : 0] = program_of(
        driver, "screen.vert", {"g_buffer.glsl", "sky.glsl", "view_environment.glsl", "compose.frag"}, {},
        view_environment_preface(has_map));
  }
}

void ViewDrawing::show(ViewState state) {
  state = with_sides_up_to(std::move(state), limits_.texture_side);
  load(state);
  if (state.size != state_.size) {
    full_.reset();
    more_.reset();
    draft_.reset();
    sum_.reset();
    sum_target_.reset();
    screen_.reset();
    restart();
  }
  if (!is_same(state.request, state_.request)) restart();
  const bool has_other_image = state.rendered != state_.rendered;
  state_ = std::move(state);
  if (has_other_image) load_rendered();
  load_plate();
  if (passes_ == 0 && !has_quick_) prepare();
}

void ViewDrawing::load(const ViewState& state) {
  const bool has_other_objects = state.objects != state_.objects;
  const bool has_other_faces = has_other_objects && scene_.set_objects(state.objects);
  if (has_other_faces || state.selection != state_.selection) scene_.set_selection(*state.selection);
  if (has_other_objects || state.textures != state_.textures) {
    for (const ReadTexture& former : state_.textures) {
      if (std::ranges::find(state.textures, former) == state.textures.end())
        scene_.forget_texture(former.path);
    }
    for (const ReadTexture& texture : state.textures) scene_.set_texture(texture.path, texture.image.get());
    restart();
  }
  if (!has_other_objects && state.shapes == state_.shapes && state.hidden == state_.hidden) return;
  if (scene_.set_shapes(state.shapes, *state.hidden)) restart();
  has_quick_ = false;
}

QStringList ViewDrawing::limitations() const {
  QStringList texts;
  const bool has_brdfs = state_.request.style.mode == DisplayMode::Brdf;
  for (const auto& [keyword, why] :
       has_brdfs ? renderer_.failed_shaders() : std::map<std::string, QString>()) {
    texts += tr("The graphics driver cannot compile the shader of the BRDF %1: the 3D view shades it on the "
                "CPU, more slowly: %2")
                 .arg(QString::fromStdString(keyword), why);
  }
  for (const std::string& keyword : has_brdfs ? scene_.surfaces().not_shown : std::set<std::string>()) {
    texts += tr("The BRDF %1 is previewed as diffuse in the 3D view").arg(QString::fromStdString(keyword));
  }
  for (const std::string& path : scene_.reduced_textures()) {
    texts += tr("The 3D view shows %1 at a lower resolution: the graphics driver's textures have at most %2 "
                "pixels per row")
                 .arg(QString::fromStdString(path))
                 .arg(limits_.texture_side);
  }
  if (scene_.left_out() > 0) {
    texts += tr("The 3D view leaves out %1 of %2 meshes: the graphics driver's buffers have at most %3 "
                "entries. Split the scene into files, and open one at a time")
                 .arg(scene_.left_out())
                 .arg(state_.objects->meshes.size())
                 .arg(limits_.buffer_texels);
  }
  return texts;
}

/// Discards the image.
void ViewDrawing::restart() {
  passes_ = 0;
  steps_.clear();
  has_quick_ = false;
}

/// Ensures that there is an image: the full one if it takes only milliseconds.
void ViewDrawing::prepare() {
  if (!is_slow_) {
    QElapsedTimer clock;
    clock.start();
    work([&clock] { return seconds(clock) > QuickEnough; });
    is_slow_ = is_slow_ || passes_ == 0;
  }
  if (passes_ == 0) draw_draft();
}

void ViewDrawing::draw_draft() {
  const QSize size((state_.size.width() + quick_scale_ - 1) / quick_scale_,
                   (state_.size.height() + quick_scale_ - 1) / quick_scale_);
  if (!draft_ || draft_->size() != size) draft_ = std::make_unique<GBuffer>(gl_, size);
  QElapsedTimer clock;
  clock.start();
  FrameRequest draft = state_.request;
  draft.is_draft = true;
  for (const auto& step : renderer_.steps(scene_, *draft_, draft)) step();
  gl_.glFinish();
  if (seconds(clock) > TooLong && quick_scale_ < LargestScale) {
    ++quick_scale_;
  } else if (seconds(clock) < Short && quick_scale_ > 1) {
    --quick_scale_;
  }
  has_quick_ = true;
}

void ViewDrawing::begin_pass() {
  auto& buffer = passes_ == 0 ? full_ : more_;
  if (!buffer) buffer = std::make_unique<GBuffer>(gl_, state_.size);
  FrameRequest request = state_.request;
  request.pass = passes_;
  // R2 points fill the pixel evenly, the first at its centre.
  request.shift = {std::fmod(0.5 + 0.7548776662 * passes_, 1) - 0.5,
                   std::fmod(0.5 + 0.5698402910 * passes_, 1) - 0.5};
  steps_ = renderer_.steps(scene_, *buffer, request);
  steps_.emplace_back([this] { accumulate(); });
  next_step_ = 0;
  if (passes_ == 0) first_pass_seconds_ = 0;
}

void ViewDrawing::accumulate() {
  if (!sum_) {
    sum_ = std::make_unique<GlObject>(gl_, GlKind::Texture);
    sum_target_ = std::make_unique<GlObject>(gl_, GlKind::Framebuffer);
    gl_.glBindTexture(GL_TEXTURE_2D, sum_->name());
    gl_.glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16F, state_.size.width(), state_.size.height(), 0, GL_RGBA,
                     GL_FLOAT, nullptr);
    gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl_.glBindFramebuffer(GL_FRAMEBUFFER, sum_target_->name());
    gl_.glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, sum_->name(), 0);
  }
  gl_.glBindFramebuffer(GL_FRAMEBUFFER, sum_target_->name());
  gl_.glViewport(0, 0, state_.size.width(), state_.size.height());
  gl_.glDisable(GL_DEPTH_TEST);
  passes_ > 0 ? gl_.glEnable(GL_BLEND) : gl_.glDisable(GL_BLEND);
  gl_.glBlendFunc(GL_ONE, GL_ONE);
  accumulate_->bind();
  set_shader_units(*accumulate_);
  (passes_ == 0 ? full_ : more_)->bind_textures(GBufferUnit);
  gl_.glBindVertexArray(no_vertices_.name());
  gl_.glDrawArrays(GL_TRIANGLES, 0, 3);
  gl_.glDisable(GL_BLEND);
}

bool ViewDrawing::work(const std::function<bool()>& is_enough) {
  if (state_.objects == nullptr || is_done()) return false;
  QElapsedTimer clock;
  clock.start();
  if (steps_.empty()) begin_pass();
  do {
    steps_[next_step_++]();
    gl_.glFinish();
  } while (next_step_ < steps_.size() && !is_enough());
  if (passes_ == 0) first_pass_seconds_ += seconds(clock);
  if (next_step_ < steps_.size()) return false;
  steps_.clear();
  ++passes_;
  // The next full image, such as of an edited scene, will take about as long: it is not tried before a draft.
  if (passes_ == 1) is_slow_ = first_pass_seconds_ > QuickEnough;
  // Further passes change the image less and less.
  return std::has_single_bit(static_cast<unsigned>(passes_));
}

std::vector<FacePixel> ViewDrawing::faces_in(const QRect& rectangle) {
  while (passes_ == 0 && state_.objects != nullptr) work([] { return false; });
  std::vector<FacePixel> pixels(static_cast<std::size_t>(rectangle.width()) *
                                static_cast<std::size_t>(rectangle.height()));
  full_->begin(GBuffer::Target::Geometry);
  gl_.glPixelStorei(GL_PACK_ALIGNMENT, 4);
  gl_.glReadPixels(rectangle.x(), rectangle.y(), rectangle.width(), rectangle.height(), GL_RG_INTEGER,
                   GL_UNSIGNED_INT, pixels.data());
  for (FacePixel& pixel : pixels) pixel.instance &= 0x7fffffffU;
  return pixels;
}

QImage ViewDrawing::image() {
  if (screen_ == nullptr) {
    screen_ = std::make_unique<QOpenGLFramebufferObject>(state_.size, QOpenGLFramebufferObject::Depth);
  }
  compose();
  for (const OverlayLayer& layer : state_.overlay) {
    overlay_.draw(layer, state_.request.camera, state_.request.bounds, state_.screen);
  }
  gl_.glBindVertexArray(0);
  QImage image(state_.size, QImage::Format_RGB32);
  gl_.glPixelStorei(GL_PACK_ALIGNMENT, 4);
  gl_.glReadPixels(0, 0, image.width(), image.height(), GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, image.bits());
  image = std::move(image).mirrored();  // OpenGL's rows start at the bottom
  image.setDevicePixelRatio(state_.screen.pixel_ratio);
  return image;
}

void ViewDrawing::load_rendered() {
  rendered_.reset();
  if (state_.rendered == nullptr) return;
  QImage image = state_.rendered->convertToFormat(QImage::Format_ARGB32_Premultiplied);
  const int most = limits_.texture_side;
  if (std::max(image.width(), image.height()) > most) image = image.scaled(most, most, Qt::KeepAspectRatio);
  rendered_ = std::make_unique<GlObject>(gl_, GlKind::Texture);
  gl_.glActiveTexture(GL_TEXTURE0 + RenderedUnit);
  gl_.glBindTexture(GL_TEXTURE_2D, rendered_->name());
  gl_.glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  gl_.glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, image.width(), image.height(), 0, GL_BGRA,
                   GL_UNSIGNED_INT_8_8_8_8_REV, image.constBits());
  gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

/// Loads the backplate in the display mode that shows it, at a resolution within the driver's limits.
void ViewDrawing::load_plate() {
  const auto& environment = state_.request.environment;
  const bool is_shown = environment && state_.request.style.mode == DisplayMode::Brdf;
  const auto plate = is_shown ? environment->backplate : nullptr;
  if (plate == loaded_plate_) return;
  loaded_plate_ = plate;
  plate_.reset();
  if (plate == nullptr || std::max(plate->width, plate->height) > limits_.texture_side) return;
  plate_ = std::make_unique<GlObject>(gl_, GlKind::Texture);
  gl_.glActiveTexture(GL_TEXTURE0 + PlateUnit);
  gl_.glBindTexture(GL_TEXTURE_2D, plate_->name());
  gl_.glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  gl_.glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB32F, plate->width, plate->height, 0, GL_RGB, GL_FLOAT,
                   plate->pixels.data());
  gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

/// Sets what is behind the scene. An orthographic camera sees as much of the environment as the same one in
/// perspective, since all its rays would see one point.
void ViewDrawing::set_background(QOpenGLShaderProgram& program) {
  const FrameRequest& request = state_.request;
  const double tangent = std::tan(request.camera.field_of_view() * std::numbers::pi / 360);
  program.setUniformValue("view_forward", to_qt(request.camera.forward()));
  program.setUniformValue("view_right", to_qt(request.camera.right() * (tangent * request.aspect)));
  program.setUniformValue("view_up", to_qt(request.camera.up() * tangent));
  renderer_.set_environment(program, request);
  program.setUniformValue("plate", static_cast<GLint>(PlateUnit));
  program.setUniformValue("plate_width",
                          plate_ ? static_cast<float>(state_.backplate_aspect / request.aspect) : 0.0F);
  program.setUniformValue("plate_scale", plate_ ? request.environment->backplate_scale : 1.0F);
  program.setUniformValue("background_top", rgb(state_.colours.background_top));
  program.setUniformValue("background_bottom", rgb(state_.colours.background_bottom));
  gl_.glActiveTexture(GL_TEXTURE0 + PlateUnit);
  gl_.glBindTexture(GL_TEXTURE_2D, plate_ ? plate_->name() : 0);
}

/// Composes the current image for the screen.
void ViewDrawing::compose() {
  const GBuffer& buffer = is_full() ? *full_ : *draft_;
  const QSizeF size = buffer.size();
  screen_->bind();
  gl_.glViewport(0, 0, state_.size.width(), state_.size.height());
  gl_.glDisable(GL_BLEND);
  gl_.glDisable(GL_SCISSOR_TEST);
  gl_.glEnable(GL_DEPTH_TEST);
  gl_.glDepthFunc(GL_ALWAYS);
  gl_.glDepthMask(GL_TRUE);
  buffer.bind_textures(GBufferUnit);
  scene_.bind_tables(TablesUnit);
  QOpenGLShaderProgram& program = *compose_[renderer_.has_map(state_.request) ? 1 : 0];
  program.bind();
  set_shader_units(program);
  program.setUniformValue("sum", static_cast<GLint>(ImageUnit));
  program.setUniformValue("has_selection", scene_.has_selection());
  program.setUniformValue("has_borders", is_full());  // expensive
  program.setUniformValue("sum_weight", is_full() ? 1 / static_cast<float>(passes_) : 0.0F);
  program.setUniformValue("to_picture",
                          QPointF(size.width() / state_.size.width(), size.height() / state_.size.height()));
  set_background(program);
  program.setUniformValue("size", QPointF(state_.size.width(), state_.size.height()));
  program.setUniformValue("rendered", static_cast<GLint>(RenderedUnit));
  program.setUniformValue("has_rendered", rendered_ != nullptr);
  program.setUniformValue("accent", rgb(state_.colours.accent));
  program.setUniformValue("fill", AccentFill);
  if (is_full()) {
    gl_.glActiveTexture(GL_TEXTURE0 + ImageUnit);
    gl_.glBindTexture(GL_TEXTURE_2D, sum_->name());
  }
  if (rendered_) {
    gl_.glActiveTexture(GL_TEXTURE0 + RenderedUnit);
    gl_.glBindTexture(GL_TEXTURE_2D, rendered_->name());
  }
  gl_.glBindVertexArray(no_vertices_.name());
  gl_.glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace editor
