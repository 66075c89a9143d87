// RAII classes own OpenGL objects. They are created, used and destroyed while their context is current.
#pragma once

#include <QOpenGLShaderProgram>
#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <stdexcept>
#include <utility>

#include <QOpenGLFunctions_3_3_Core>

#include "editor/graphics/graphics_driver.h"
#include "grf/math.h"

namespace editor {

using Gl = QOpenGLFunctions_3_3_Core;

/// An offset in a buffer, in bytes, as OpenGL takes it.
inline const void* gl_offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }  // NOLINT

enum class GlKind { Buffer, Texture, Framebuffer, VertexArray };

class GlObject {
 public:
  GlObject(Gl& gl, GlKind kind);
  ~GlObject();
  GlObject(GlObject&& other) noexcept
      : gl_(other.gl_), kind_(other.kind_), name_(std::exchange(other.name_, 0)) {}
  GlObject(const GlObject&) = delete;
  GlObject& operator=(const GlObject&) = delete;
  GlObject& operator=(GlObject&&) = delete;

  GLuint name() const { return name_; }

 private:
  Gl& gl_;
  GlKind kind_;
  GLuint name_ = 0;
};

/// An array of objects of a kind.
template <std::size_t Count>
std::array<GlObject, Count> gl_objects(Gl& gl, GlKind kind) {
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    return std::array<GlObject, Count>{(static_cast<void>(I), GlObject(gl, kind))...};
  }
  (std::make_index_sequence<Count>());
}

/// A buffer texture: an array that shaders read by index.
class BufferTexture {
 public:
  /// `format` is that of an element, such as GL_R32UI.
  BufferTexture(Gl& gl, GLenum format);

  template <class T>
  void upload(std::span<const T> values) {
    upload(values.data(), values.size_bytes());
  }
  void bind(GLuint unit) const;

 private:
  void upload(const void* data, std::size_t bytes);

  Gl& gl_;
  GLenum format_;
  GlObject buffer_;
  GlObject texture_;
};

/// Thrown if the driver cannot compile a shader that is indispensable.
class ShaderCompileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Compiles a shader program from files under :/view/: those of the fragment shader are concatenated after
/// `preface`, and the geometry shader is optional. Throws ShaderCompileError.
std::unique_ptr<QOpenGLShaderProgram> program_of(const GraphicsDriver& driver, const QString& vertex,
                                                 const QStringList& fragments, const QString& geometry = {},
                                                 const QByteArray& preface = {});
/// The concatenated files under :/view/.
QByteArray shader_text(const QStringList& names);
inline const QByteArray GlslVersion = "#version 330 core\n";

/// Converts a matrix for shaders.
QMatrix4x4 to_qt(const grf::Matrix44d& matrix);
inline QVector3D to_qt(const grf::Vec3d& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

}  // namespace editor
