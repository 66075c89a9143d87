#include "editor/tools/brdf_layers.h"

namespace editor {

BrdfLayers::BrdfLayers(Gl& gl, const QSize& size)
    : gl_(gl),
      size_(size),
      normals_(gl, GlKind::Texture),
      depth_(gl, GlKind::Texture),
      radiance_(gl, GlKind::Texture),
      normal_target_(gl, GlKind::Framebuffer),
      radiance_target_(gl, GlKind::Framebuffer) {
  make(normals_, GL_RGBA32F, GL_RGBA);
  make(depth_, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT);
  make(radiance_, GL_RGBA32F, GL_RGBA);
  const auto attach = [this](const GlObject& target, GLenum place, const GlObject& texture) {
    gl_.glBindFramebuffer(GL_FRAMEBUFFER, target.name());
    gl_.glFramebufferTexture2D(GL_FRAMEBUFFER, place, GL_TEXTURE_2D, texture.name(), 0);
  };
  attach(normal_target_, GL_COLOR_ATTACHMENT0, normals_);
  attach(normal_target_, GL_DEPTH_ATTACHMENT, depth_);
  attach(radiance_target_, GL_COLOR_ATTACHMENT0, radiance_);
}

void BrdfLayers::make(const GlObject& texture, GLenum format, GLenum layout) {
  gl_.glActiveTexture(GL_TEXTURE0);
  gl_.glBindTexture(GL_TEXTURE_2D, texture.name());
  gl_.glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), size_.width(), size_.height(), 0, layout,
                   GL_FLOAT, nullptr);
  const GLint filter = &texture == &radiance_ ? GL_LINEAR : GL_NEAREST;
  gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void BrdfLayers::begin_normals() {
  gl_.glBindFramebuffer(GL_FRAMEBUFFER, normal_target_.name());
  gl_.glViewport(0, 0, size_.width(), size_.height());
}

void BrdfLayers::begin_radiance() {
  gl_.glBindFramebuffer(GL_FRAMEBUFFER, radiance_target_.name());
  gl_.glViewport(0, 0, size_.width(), size_.height());
}

void BrdfLayers::clear_radiance() {
  begin_radiance();
  gl_.glClearColor(0, 0, 0, 0);
  gl_.glClear(GL_COLOR_BUFFER_BIT);
}

void BrdfLayers::bind(const GlObject& texture, GLuint unit) const {
  gl_.glActiveTexture(GL_TEXTURE0 + unit);
  gl_.glBindTexture(GL_TEXTURE_2D, texture.name());
}

std::vector<float> BrdfLayers::read(const QRect& place) {
  std::vector<float> values(4 * static_cast<std::size_t>(place.width()) *
                            static_cast<std::size_t>(place.height()));
  gl_.glPixelStorei(GL_PACK_ALIGNMENT, 4);
  gl_.glReadPixels(place.x(), place.y(), place.width(), place.height(), GL_RGBA, GL_FLOAT, values.data());
  return values;
}

std::vector<float> BrdfLayers::read_normals(const QRect& place) {
  begin_normals();
  return read(place);
}

std::vector<float> BrdfLayers::read_radiance(const QRect& place) {
  begin_radiance();
  return read(place);
}

void BrdfLayers::set_radiance(const QRect& place, const std::vector<float>& values) {
  bind(radiance_, 0);
  gl_.glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  gl_.glTexSubImage2D(GL_TEXTURE_2D, 0, place.x(), place.y(), place.width(), place.height(), GL_RGBA,
                      GL_FLOAT, values.data());
}

}  // namespace editor
