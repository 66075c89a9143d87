#include "editor/view/g_buffer.h"

namespace editor {

GBuffer::GBuffer(Gl& gl, const QSize& size)
    : gl_(gl),
      size_(size),
      textures_(gl_objects<LayerCount>(gl, GlKind::Texture)),
      targets_(gl_objects<4>(gl, GlKind::Framebuffer)) {
  make_texture(Faces, GL_RG32UI, GL_RG_INTEGER, GL_UNSIGNED_INT);
  make_texture(Normals, GL_RGBA16, GL_RGBA, GL_UNSIGNED_SHORT);
  make_texture(Values, GL_RGBA16F, GL_RGBA, GL_FLOAT);
  make_texture(Uvs, GL_RG32F, GL_RG, GL_FLOAT);
  make_texture(Depth, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT);
  make_texture(Light, GL_RGBA16F, GL_RGBA, GL_FLOAT);
  make_texture(Colour, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE);
  attach(Target::Geometry, {Faces, Normals, Values, Uvs}, true);
  attach(Target::Values, {Values}, false);
  attach(Target::Light, {Light}, false);
  attach(Target::Colour, {Colour}, true);
}

void GBuffer::make_texture(Layer layer, GLenum format, GLenum layout, GLenum type) {
  gl_.glBindTexture(GL_TEXTURE_2D, textures_[layer].name());
  gl_.glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), size_.width(), size_.height(), 0, layout,
                   type, nullptr);
  const GLint filter = layer == Colour ? GL_LINEAR : GL_NEAREST;
  gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void GBuffer::attach(Target target, std::initializer_list<Layer> colours, bool has_depth) {
  begin(target);
  std::vector<GLenum> places;
  const auto add = [this](GLenum place, Layer layer) {
    gl_.glFramebufferTexture2D(GL_FRAMEBUFFER, place, GL_TEXTURE_2D, textures_[layer].name(), 0);
  };
  for (const Layer colour : colours) {
    places.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(places.size()));
    add(places.back(), colour);
  }
  if (has_depth) add(GL_DEPTH_ATTACHMENT, Depth);
  gl_.glDrawBuffers(static_cast<GLsizei>(places.size()), places.data());
}

void GBuffer::begin(Target target) {
  gl_.glBindFramebuffer(GL_FRAMEBUFFER, targets_[static_cast<std::size_t>(target)].name());
  gl_.glViewport(0, 0, size_.width(), size_.height());
}

GBuffer::Rows GBuffer::read_rows(int first, int count) {
  const std::size_t size = static_cast<std::size_t>(size_.width()) * static_cast<std::size_t>(count);
  Rows rows{std::vector<std::array<GLuint, 2>>(size), std::vector<Imath::V4f>(size),
            std::vector<Imath::V4f>(size), std::vector<Imath::V3f>(size)};
  const auto read = [&](GLenum attachment, GLenum layout, GLenum type, void* values) {
    gl_.glReadBuffer(attachment);
    gl_.glReadPixels(0, first, size_.width(), count, layout, type, values);
  };
  gl_.glPixelStorei(GL_PACK_ALIGNMENT, 4);
  begin(Target::Geometry);
  read(GL_COLOR_ATTACHMENT1, GL_RGBA, GL_FLOAT, rows.normals.data());
  read(GL_COLOR_ATTACHMENT2, GL_RGBA, GL_FLOAT, rows.values.data());
  read(GL_COLOR_ATTACHMENT0, GL_RG_INTEGER, GL_UNSIGNED_INT, rows.faces.data());
  begin(Target::Light);
  read(GL_COLOR_ATTACHMENT0, GL_RGB, GL_FLOAT, rows.light.data());
  return rows;
}

void GBuffer::set_light(int first, const std::vector<Imath::V3f>& light) {
  const auto count = static_cast<GLsizei>(light.size()) / size_.width();
  gl_.glActiveTexture(GL_TEXTURE0);
  gl_.glBindTexture(GL_TEXTURE_2D, textures_[Light].name());
  gl_.glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  gl_.glTexSubImage2D(GL_TEXTURE_2D, 0, 0, first, size_.width(), count, GL_RGB, GL_FLOAT, light.data());
}

void GBuffer::bind_textures(GLuint first_unit) const {
  GLuint unit = GL_TEXTURE0 + first_unit;
  for (const GlObject& texture : textures_) {
    gl_.glActiveTexture(unit++);
    gl_.glBindTexture(GL_TEXTURE_2D, texture.name());
  }
}

}  // namespace editor
