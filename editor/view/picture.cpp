#include "editor/view/picture.h"

#include <array>

namespace editor {

Picture::Picture(Gl& gl, const QSize& size)
    : gl_(gl),
      size_(size),
      faces_(gl, GlKind::Texture),
      normals_(gl, GlKind::Texture),
      values_(gl, GlKind::Texture),
      uvs_(gl, GlKind::Texture),
      depth_(gl, GlKind::Texture),
      light_(gl, GlKind::Texture),
      colour_(gl, GlKind::Texture),
      geometry_target_(gl, GlKind::Framebuffer),
      values_target_(gl, GlKind::Framebuffer),
      light_target_(gl, GlKind::Framebuffer),
      colour_target_(gl, GlKind::Framebuffer) {
  make_texture(faces_, GL_RG32UI, GL_RG_INTEGER, GL_UNSIGNED_INT, GL_NEAREST);
  make_texture(normals_, GL_RGBA16, GL_RGBA, GL_UNSIGNED_SHORT, GL_NEAREST);
  make_texture(values_, GL_RGBA16F, GL_RGBA, GL_FLOAT, GL_NEAREST);
  make_texture(uvs_, GL_RG32F, GL_RG, GL_FLOAT, GL_NEAREST);
  make_texture(depth_, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, GL_NEAREST);
  make_texture(light_, GL_RGBA16F, GL_RGBA, GL_FLOAT, GL_NEAREST);
  make_texture(colour_, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, GL_LINEAR);
  attach(geometry_target_, {&faces_, &normals_, &values_, &uvs_}, true);
  attach(values_target_, {&values_}, false);
  attach(light_target_, {&light_}, false);
  attach(colour_target_, {&colour_}, true);
}

void Picture::make_texture(const GlObject& texture, GLenum format, GLenum layout, GLenum type,
                           GLenum filter) {
  gl_.glBindTexture(GL_TEXTURE_2D, texture.name());
  gl_.glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), size_.width(), size_.height(), 0, layout,
                   type, nullptr);
  gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(filter));
  gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, static_cast<GLint>(filter));
  gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void Picture::attach(const GlObject& target, std::initializer_list<const GlObject*> colours, bool has_depth) {
  gl_.glBindFramebuffer(GL_FRAMEBUFFER, target.name());
  static constexpr std::array<GLenum, 4> Places = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1,
                                                   GL_COLOR_ATTACHMENT2, GL_COLOR_ATTACHMENT3};
  std::size_t count = 0;
  for (const GlObject* colour : colours) {
    gl_.glFramebufferTexture2D(GL_FRAMEBUFFER, Places[count++], GL_TEXTURE_2D, colour->name(), 0);
  }
  if (has_depth) {
    gl_.glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_.name(), 0);
  }
  gl_.glDrawBuffers(static_cast<GLsizei>(count), Places.data());
}

void Picture::begin(const GlObject& target) {
  gl_.glBindFramebuffer(GL_FRAMEBUFFER, target.name());
  gl_.glViewport(0, 0, size_.width(), size_.height());
}

void Picture::begin_geometry() { begin(geometry_target_); }
void Picture::begin_values() { begin(values_target_); }
void Picture::begin_light() { begin(light_target_); }
void Picture::begin_colour() { begin(colour_target_); }
void Picture::begin_reading_faces() { begin(geometry_target_); }

Picture::Rows Picture::read_rows(int first, int count) {
  const std::size_t size = static_cast<std::size_t>(size_.width()) * static_cast<std::size_t>(count);
  Rows rows{std::vector<std::array<GLuint, 2>>(size), std::vector<Imath::V4f>(size),
            std::vector<Imath::V4f>(size), std::vector<Imath::V3f>(size)};
  const auto read = [&](GLenum attachment, GLenum layout, GLenum type, void* values) {
    gl_.glReadBuffer(attachment);
    gl_.glReadPixels(0, first, size_.width(), count, layout, type, values);
  };
  gl_.glPixelStorei(GL_PACK_ALIGNMENT, 4);
  begin_geometry();
  read(GL_COLOR_ATTACHMENT1, GL_RGBA, GL_FLOAT, rows.normals.data());
  read(GL_COLOR_ATTACHMENT2, GL_RGBA, GL_FLOAT, rows.values.data());
  read(GL_COLOR_ATTACHMENT0, GL_RG_INTEGER, GL_UNSIGNED_INT, rows.faces.data());
  begin_light();
  read(GL_COLOR_ATTACHMENT0, GL_RGB, GL_FLOAT, rows.light.data());
  return rows;
}

void Picture::set_light(int first, const std::vector<Imath::V3f>& light) {
  const auto count = static_cast<GLsizei>(light.size()) / size_.width();
  gl_.glActiveTexture(GL_TEXTURE0);
  gl_.glBindTexture(GL_TEXTURE_2D, light_.name());
  gl_.glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  gl_.glTexSubImage2D(GL_TEXTURE_2D, 0, 0, first, size_.width(), count, GL_RGB, GL_FLOAT, light.data());
}

void Picture::bind_textures(GLuint first_unit) const {
  GLuint unit = GL_TEXTURE0 + first_unit;
  for (const GlObject* texture : {&faces_, &normals_, &values_, &uvs_, &depth_, &light_, &colour_}) {
    gl_.glActiveTexture(unit++);
    gl_.glBindTexture(GL_TEXTURE_2D, texture->name());
  }
}

}  // namespace editor
