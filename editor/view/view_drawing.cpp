#include "editor/view/view_drawing.h"

namespace editor {
namespace {

/// How much of the accent selected faces take.
constexpr float AccentFill = 0.45F;

QVector3D rgb(const QColor& colour) { return {colour.redF(), colour.greenF(), colour.blueF()}; }

}  // namespace

ViewDrawing::ViewDrawing(Gl& gl, const GraphicsDriver& driver)
    : gl_(gl),
      scene_(gl),
      pictures_(gl, driver, scene_),
      overlay_(gl, driver),
      no_vertices_(gl, GlKind::VertexArray),
      compose_(program_of(driver, "screen.vert", {"picture.glsl", "compose.frag"})) {}

void ViewDrawing::show(const ViewState& state) {
  load(state);
  state_ = state;
  pictures_.request(state_.request, state_.size);
  pictures_.prepare();
}

void ViewDrawing::load(const ViewState& state) {
  const bool has_other_objects = state.objects != state_.objects;
  const bool has_other_faces = has_other_objects && scene_.set_objects(state.objects);
  if (has_other_faces || state.selection != state_.selection) scene_.set_selection(*state.selection);
  if (has_other_objects || state.textures != state_.textures) {
    for (const ReadTexture& texture : state.textures) scene_.set_texture(texture.path, texture.image.get());
    pictures_.invalidate();
  }
  if (!has_other_objects && state.shapes == state_.shapes) return;
  if (scene_.set_shapes(state.shapes)) pictures_.invalidate();
  pictures_.invalidate_quick();
}

QImage ViewDrawing::image() {
  if (screen_ == nullptr || screen_->size() != state_.size) {
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
  image = std::move(image).mirrored();  // OpenGL has rows from the bottom
  image.setDevicePixelRatio(state_.screen.pixel_ratio);
  return image;
}

void ViewDrawing::compose() {
  screen_->bind();
  gl_.glViewport(0, 0, state_.size.width(), state_.size.height());
  gl_.glDisable(GL_BLEND);
  gl_.glDisable(GL_SCISSOR_TEST);
  gl_.glEnable(GL_DEPTH_TEST);
  gl_.glDepthFunc(GL_ALWAYS);
  gl_.glDepthMask(GL_TRUE);
  compose_->bind();
  set_picture_units(*compose_);
  pictures_.bind_shown(*compose_);
  compose_->setUniformValue("background_top", rgb(state_.colours.background_top));
  compose_->setUniformValue("background_bottom", rgb(state_.colours.background_bottom));
  compose_->setUniformValue("height", static_cast<float>(state_.size.height()));
  compose_->setUniformValue("accent", rgb(state_.colours.accent));
  compose_->setUniformValue("fill", AccentFill);
  gl_.glBindVertexArray(no_vertices_.name());
  gl_.glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace editor
