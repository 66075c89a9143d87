#include "editor/view/view_pictures.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace editor {
namespace {

/// A full picture that takes longer waits for the view to rest.
constexpr double QuickEnough = 0.03;
/// Of a quick picture: above and below, the next one has fewer or more pixels.
constexpr double TooLong = 0.02;
constexpr double Short = 0.007;
constexpr int LargestScale = 4;

bool is_same(const PictureRequest& a, const PictureRequest& b) {
  return a.camera == b.camera && a.bounds == b.bounds && a.style == b.style && a.aspect == b.aspect;
}

double seconds(const QElapsedTimer& clock) { return static_cast<double>(clock.nsecsElapsed()) * 1e-9; }

}  // namespace

ViewPictures::ViewPictures(Gl& gl, const GraphicsDriver& driver, SceneBuffers& scene)
    : gl_(gl), scene_(scene), painter_(gl, driver), no_vertices_(gl, GlKind::VertexArray) {
  accumulate_ = program_of(driver, "screen.vert", {"picture.glsl", "accumulate.frag"});
}

void ViewPictures::request(const PictureRequest& request, const QSize& size) {
  if (request_ && is_same(*request_, request) && size == size_) return;
  if (size != size_) {
    size_ = size;
    full_.reset();
    more_.reset();
    quick_.reset();
    sum_.reset();
    sum_target_.reset();
  }
  request_ = request;
  passes_ = 0;
  steps_.clear();
  has_quick_ = false;
}

void ViewPictures::invalidate() {
  passes_ = 0;
  steps_.clear();
  has_quick_ = false;
}

void ViewPictures::prepare() {
  if (passes_ > 0 || has_quick_) return;
  if (!is_slow_) {
    QElapsedTimer clock;
    clock.start();
    work([&clock] { return seconds(clock) > QuickEnough; });
    is_slow_ = is_slow_ || passes_ == 0;
  }
  if (passes_ == 0) paint_quick();
}

void ViewPictures::paint_quick() {
  const QSize size((size_.width() + quick_scale_ - 1) / quick_scale_,
                   (size_.height() + quick_scale_ - 1) / quick_scale_);
  if (!quick_ || quick_->size() != size) quick_ = std::make_unique<Picture>(gl_, size);
  QElapsedTimer clock;
  clock.start();
  PictureRequest quick = *request_;
  quick.is_quick = true;
  for (const auto& step : painter_.steps(scene_, *quick_, quick)) step();
  gl_.glFinish();
  if (seconds(clock) > TooLong && quick_scale_ < LargestScale) {
    ++quick_scale_;
  } else if (seconds(clock) < Short && quick_scale_ > 1) {
    --quick_scale_;
  }
  has_quick_ = true;
}

void ViewPictures::begin_pass() {
  auto& picture = passes_ == 0 ? full_ : more_;
  if (!picture) picture = std::make_unique<Picture>(gl_, size_);
  PictureRequest request = *request_;
  request.pass = passes_;
  // Points that fill the pixel evenly, the first in its centre.
  request.shift = {std::fmod(0.5 + 0.7548776662 * passes_, 1) - 0.5,
                   std::fmod(0.5 + 0.5698402910 * passes_, 1) - 0.5};
  steps_ = painter_.steps(scene_, *picture, request);
  steps_.emplace_back([this] { accumulate(); });
  next_step_ = 0;
  if (passes_ == 0) first_pass_seconds_ = 0;
}

void ViewPictures::accumulate() {
  if (!sum_) {
    sum_ = std::make_unique<GlObject>(gl_, GlKind::Texture);
    sum_target_ = std::make_unique<GlObject>(gl_, GlKind::Framebuffer);
    gl_.glBindTexture(GL_TEXTURE_2D, sum_->name());
    gl_.glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16F, size_.width(), size_.height(), 0, GL_RGBA, GL_FLOAT,
                     nullptr);
    gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl_.glBindFramebuffer(GL_FRAMEBUFFER, sum_target_->name());
    gl_.glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, sum_->name(), 0);
  }
  gl_.glBindFramebuffer(GL_FRAMEBUFFER, sum_target_->name());
  gl_.glViewport(0, 0, size_.width(), size_.height());
  gl_.glDisable(GL_DEPTH_TEST);
  passes_ > 0 ? gl_.glEnable(GL_BLEND) : gl_.glDisable(GL_BLEND);
  gl_.glBlendFunc(GL_ONE, GL_ONE);
  accumulate_->bind();
  set_picture_units(*accumulate_);
  (passes_ == 0 ? full_ : more_)->bind_textures(PictureUnit);
  gl_.glBindVertexArray(no_vertices_.name());
  gl_.glDrawArrays(GL_TRIANGLES, 0, 3);
  gl_.glDisable(GL_BLEND);
}

bool ViewPictures::work(const std::function<bool()>& is_enough) {
  if (!request_ || size_.isEmpty() || is_done()) return false;
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
  // The next one, of an edited scene say, will take about as long: it is not tried before the quick one.
  if (passes_ == 1) is_slow_ = first_pass_seconds_ > QuickEnough;
  // The more there are, the less one of them changes.
  return std::has_single_bit(static_cast<unsigned>(passes_));
}

void ViewPictures::finish_first_pass() {
  while (passes_ == 0 && request_ && !size_.isEmpty()) work([] { return false; });
}

void ViewPictures::bind_shown(QOpenGLShaderProgram& compose) {
  Picture& picture = passes_ > 0 ? *full_ : *quick_;
  picture.bind_textures(PictureUnit);
  scene_.bind_tables(TablesUnit);
  compose.setUniformValue("sum", static_cast<GLint>(ImageUnit));
  compose.setUniformValue("has_selection", scene_.has_selection());
  compose.setUniformValue("has_borders", passes_ > 0);  // they cost more than all else
  compose.setUniformValue("sum_weight", passes_ > 0 ? 1 / static_cast<float>(passes_) : 0.0F);
  compose.setUniformValue(
      "to_picture",
      QVector2D(static_cast<float>(picture.size().width()) / static_cast<float>(size_.width()),
                static_cast<float>(picture.size().height()) / static_cast<float>(size_.height())));
  if (passes_ == 0) return;
  gl_.glActiveTexture(GL_TEXTURE0 + ImageUnit);
  gl_.glBindTexture(GL_TEXTURE_2D, sum_->name());
}

std::vector<FacePixel> ViewPictures::faces_in(const QRect& rectangle) {
  finish_first_pass();
  std::vector<FacePixel> pixels(static_cast<std::size_t>(rectangle.width()) *
                                static_cast<std::size_t>(rectangle.height()));
  full_->begin_reading_faces();
  gl_.glPixelStorei(GL_PACK_ALIGNMENT, 4);
  gl_.glReadPixels(rectangle.x(), rectangle.y(), rectangle.width(), rectangle.height(), GL_RG_INTEGER,
                   GL_UNSIGNED_INT, pixels.data());
  for (FacePixel& pixel : pixels) pixel.instance &= 0x7fffffffU;
  return pixels;
}

}  // namespace editor
