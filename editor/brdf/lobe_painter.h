#pragma once

#include <QColor>
#include <QImage>
#include <QOpenGLBuffer>
#include <QOpenGLFramebufferObject>
#include <QOpenGLShaderProgram>
#include <QOpenGLVertexArrayObject>
#include <memory>

#include <QMatrix4x4>
#include <QVector3D>

#include "renderer/plot/lobe_mesh.h"

namespace editor {

struct LobePicture {
  std::shared_ptr<const plot::LobeMesh> mesh;
  QMatrix4x4 to_clip;
  QVector3D eye;  ///< direction towards the eye
  QColor colour;
  QColor background;
  QSize size;  ///< device pixels
};

/// Draws lobes with OpenGL. It is created, used and destroyed while its context is current.
class LobePainter {
 public:
  explicit LobePainter(QOpenGLContext& context);

  QImage paint(const LobePicture& picture);

 private:
  void upload(const plot::LobeMesh& mesh);
  void draw(const LobePicture& picture);

  QOpenGLContext& context_;
  QOpenGLShaderProgram program_;
  QOpenGLVertexArrayObject layout_;
  QOpenGLBuffer vertices_{QOpenGLBuffer::VertexBuffer};
  QOpenGLBuffer indices_{QOpenGLBuffer::IndexBuffer};
  std::unique_ptr<QOpenGLFramebufferObject> target_;
  std::shared_ptr<const plot::LobeMesh> uploaded_;
};

}  // namespace editor
