// Compiles shaders, and queries the limits of the graphics driver.
#pragma once

#include <QByteArray>
#include <QOpenGLShaderProgram>
#include <QString>
#include <cstddef>
#include <functional>
#include <memory>

namespace editor {

/// GLSL source of a program, with its `#version`. The geometry shader is optional.
struct ShaderTexts {
  QByteArray vertex;
  QByteArray fragment;
  QByteArray geometry = {};
};

struct CompiledProgram {
  std::unique_ptr<QOpenGLShaderProgram> program;  ///< null if compilation failed
  QString log;                                    ///< the driver's error log
};

/// Compiles and links in the current context.
CompiledProgram compile_program(const ShaderTexts& texts);

/// Size limits of a driver; the defaults are the minima that OpenGL 3.3 guarantees.
struct GraphicsLimits {
  int texture_side = 1024;                ///< maximum width and height of a texture
  std::size_t buffer_texels = 64 * 1024;  ///< maximum number of elements of a buffer texture
};

/// Queries the driver of the current context.
GraphicsLimits limits_of_driver();

/// The functions of a driver, which tests replace to simulate one with failures.
struct GraphicsDriver {
  std::function<CompiledProgram(const ShaderTexts&)> compile = compile_program;
  std::function<GraphicsLimits()> limits = limits_of_driver;
};

/// The first line of a driver's log, for a message.
QString first_line(const QString& log);

}  // namespace editor
