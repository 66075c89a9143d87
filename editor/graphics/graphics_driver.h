// A graphics driver compiles shaders, and may refuse one; and it has limits.
#pragma once

#include <QByteArray>
#include <QOpenGLShaderProgram>
#include <QString>
#include <cstddef>
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

/// The largest things that a driver takes; these are those that any driver of OpenGL 3.3 does.
struct GraphicsLimits {
  int texture_side = 1024;                ///< pixels of an image in either direction
  std::size_t buffer_texels = 64 * 1024;  ///< elements of a table that shaders read
};

/// Asks the driver of the context that is current.
GraphicsLimits limits_of_driver();

/// A driver, which tests replace by one that refuses more.
struct GraphicsDriver {
  std::function<CompiledProgram(const ShaderTexts&)> compile = compile_program;
  std::function<GraphicsLimits()> limits = limits_of_driver;
};

/// The first line of what a driver says, to be told in a sentence.
QString first_line(const QString& log);

}  // namespace editor
