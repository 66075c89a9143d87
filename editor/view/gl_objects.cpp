#include "editor/view/gl_objects.h"

#include <QFile>

#include <QMatrix4x4>

/// Registers the resources of the static library. The macro must be in no namespace.
static void need_resources() { Q_INIT_RESOURCE(view_shaders); }

namespace editor {
namespace {

struct GlFunctions {
  void (Gl::*make)(GLsizei, GLuint*);
  void (Gl::*destroy)(GLsizei, const GLuint*);
};

const GlFunctions& functions_of(GlKind kind) {
  static constexpr GlFunctions Functions[] = {{&Gl::glGenBuffers, &Gl::glDeleteBuffers},
                                              {&Gl::glGenTextures, &Gl::glDeleteTextures},
                                              {&Gl::glGenFramebuffers, &Gl::glDeleteFramebuffers},
                                              {&Gl::glGenVertexArrays, &Gl::glDeleteVertexArrays}};
  return Functions[static_cast<std::size_t>(kind)];
}

}  // namespace

GlObject::GlObject(Gl& gl, GlKind kind) : gl_(gl), kind_(kind) { (gl_.*functions_of(kind_).make)(1, &name_); }

GlObject::~GlObject() {
  if (name_ != 0) (gl_.*functions_of(kind_).destroy)(1, &name_);
}

BufferTexture::BufferTexture(Gl& gl, GLenum format)
    : gl_(gl), format_(format), buffer_(gl, GlKind::Buffer), texture_(gl, GlKind::Texture) {}

void BufferTexture::upload(const void* data, std::size_t bytes) {
  gl_.glBindBuffer(GL_TEXTURE_BUFFER, buffer_.name());
  // At least one element, since an empty buffer is no texture.
  const auto size = static_cast<GLsizeiptr>(bytes);
  gl_.glBufferData(GL_TEXTURE_BUFFER, size > 0 ? size : 16, size > 0 ? data : nullptr, GL_STATIC_DRAW);
  gl_.glBindTexture(GL_TEXTURE_BUFFER, texture_.name());
  gl_.glTexBuffer(GL_TEXTURE_BUFFER, format_, buffer_.name());
}

void BufferTexture::bind(GLuint unit) const {
  gl_.glActiveTexture(GL_TEXTURE0 + unit);
  gl_.glBindTexture(GL_TEXTURE_BUFFER, texture_.name());
}

QByteArray shader_text(const QStringList& names) {
  need_resources();
  QByteArray text;
  for (const QString& name : names) {
    QFile file(":/view/" + name);
    const bool is_there = file.open(QIODevice::ReadOnly);
    Q_ASSERT(is_there);
    if (is_there) text += file.readAll();
  }
  return text;
}

std::unique_ptr<QOpenGLShaderProgram> program_of(const GraphicsDriver& driver, const QString& vertex,
                                                 const QStringList& fragments, const QString& geometry,
                                                 const QByteArray& preface) {
  CompiledProgram made =
      driver.compile({GlslVersion + shader_text({vertex}), GlslVersion + preface + shader_text(fragments),
                      geometry.isEmpty() ? QByteArray() : GlslVersion + shader_text({geometry})});
  if (made.program == nullptr) {
    throw ShaderCompileError((fragments.join(' ') + ": " + first_line(made.log)).toStdString());
  }
  return std::move(made.program);
}

QMatrix4x4 to_qt(const grf::Matrix44d& matrix) {
  QMatrix4x4 result;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      // Imath multiplies row vectors, Qt column vectors.
      result(column, row) = static_cast<float>(matrix[row][column]);
    }
  }
  return result;
}

}  // namespace editor
