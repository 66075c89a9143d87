// A graphics driver compiles shaders, and may refuse one.
#pragma once

#include <QByteArray>
#include <QOpenGLShaderProgram>
#include <QString>
#include <functional>
#include <memory>

namespace editor {

/// GLSL of a program, with its `#version`. A geometry shader is optional.
struct ShaderTexts {
  QByteArray vertex;
  QByteArray fragment;
  QByteArray geometry = {};
};

struct CompiledProgram {
  std::unique_ptr<QOpenGLShaderProgram> program;  ///< null: the driver refuses it
  QString log;                                    ///< what the driver says about that
};

/// Compiles and links in the context that is current.
CompiledProgram compile_program(const ShaderTexts& texts);

/// A driver, which tests replace by one that refuses more.
struct GraphicsDriver {
  std::function<CompiledProgram(const ShaderTexts&)> compile = compile_program;
};

/// The first line of what a driver says, to be told in a sentence.
QString first_line(const QString& log);

}  // namespace editor
