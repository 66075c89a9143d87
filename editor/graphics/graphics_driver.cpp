#include "editor/graphics/graphics_driver.h"

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

QString first_line(const QString& log) { return log.trimmed().section('\n', 0, 0); }

}  // namespace editor
