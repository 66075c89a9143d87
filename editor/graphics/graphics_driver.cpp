#include "editor/graphics/graphics_driver.h"

#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <algorithm>

namespace editor {

CompiledProgram compile_program(const ShaderTexts& texts) {
  auto program = std::make_unique<QOpenGLShaderProgram>();
  const bool is_made = program->addShaderFromSourceCode(QOpenGLShader::Vertex, texts.vertex) &&
                       program->addShaderFromSourceCode(QOpenGLShader::Fragment, texts.fragment) &&
                       (texts.geometry.isEmpty() ||
                        program->addShaderFromSourceCode(QOpenGLShader::Geometry, texts.geometry)) &&
                       program->link();
  if (is_made) return {std::move(program), {}};
  return {nullptr, program->log()};
}

GraphicsLimits limits_of_driver() {
  QOpenGLFunctions& gl = *QOpenGLContext::currentContext()->functions();
  const auto stated = [&gl](GLenum name, int least) {
    GLint value = 0;
    gl.glGetIntegerv(name, &value);
    return std::max(value, least);
  };
  const GraphicsLimits least;
  return {
      stated(GL_MAX_TEXTURE_SIZE, least.texture_side),
      static_cast<std::size_t>(stated(GL_MAX_TEXTURE_BUFFER_SIZE, static_cast<int>(least.buffer_texels)))};
}

QString first_line(const QString& log) { return log.trimmed().section('\n', 0, 0); }

}  // namespace editor
