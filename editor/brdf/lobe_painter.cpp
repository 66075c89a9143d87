#include "editor/brdf/lobe_painter.h"

#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <vector>

namespace editor {
namespace {

using reflectance::Vec3f;

constexpr int SamplesPerPixel = 4;

const char* const VertexText = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 to_clip;
out vec3 point;
out vec3 direction;
void main() {
  point = position;
  direction = normal;
  gl_Position = to_clip * vec4(position, 1);
}
)";

const char* const FragmentText = R"(#version 330 core
in vec3 point;
in vec3 direction;
uniform vec3 eye;
uniform vec3 colour;
out vec4 result;
void main() {
  float facing = abs(dot(normalize(direction), eye));
  float light = 0.35 + 0.65 * facing;
  result = vec4(colour * light, 1);
}
)";

}  // namespace

LobePainter::LobePainter(QOpenGLContext& context) : context_(context) {
  program_.addShaderFromSourceCode(QOpenGLShader::Vertex, VertexText);
  program_.addShaderFromSourceCode(QOpenGLShader::Fragment, FragmentText);
  program_.link();
  layout_.create();
  vertices_.create();
  indices_.create();
}

void LobePainter::upload(const plot::LobeMesh& mesh) {
  std::vector<Vec3f> vectors;
  vectors.reserve(2 * mesh.positions.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    vectors.push_back(mesh.positions[i]);
    vectors.push_back(mesh.normals[i]);
  }
  layout_.bind();
  vertices_.bind();
  vertices_.allocate(vectors.data(), static_cast<int>(vectors.size() * sizeof(Vec3f)));
  indices_.bind();
  indices_.allocate(mesh.triangles.data(), static_cast<int>(mesh.triangles.size() * sizeof(std::uint32_t)));
  program_.bind();
  for (int k = 0; k < 2; ++k) {
    program_.enableAttributeArray(k);
    program_.setAttributeBuffer(k, GL_FLOAT, k * static_cast<int>(sizeof(Vec3f)), 3, 2 * sizeof(Vec3f));
  }
  layout_.release();
}

QImage LobePainter::paint(const LobePicture& picture) {
  if (!target_ || target_->size() != picture.size) {
    QOpenGLFramebufferObjectFormat format;
    format.setAttachment(QOpenGLFramebufferObject::Depth);
    format.setSamples(SamplesPerPixel);
    target_ = std::make_unique<QOpenGLFramebufferObject>(picture.size, format);
  }
  if (uploaded_ != picture.mesh) {
    uploaded_ = picture.mesh;
    upload(*uploaded_);
  }
  target_->bind();
  draw(picture);
  return target_->toImage();
}

void LobePainter::draw(const LobePicture& picture) {
  QOpenGLFunctions* gl = context_.functions();
  gl->glViewport(0, 0, picture.size.width(), picture.size.height());
  gl->glClearColor(picture.background.redF(), picture.background.greenF(), picture.background.blueF(), 1);
  gl->glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl->glEnable(GL_DEPTH_TEST);
  const QColor& colour = picture.colour;
  program_.bind();
  program_.setUniformValue("to_clip", picture.to_clip);
  program_.setUniformValue("eye", picture.eye);
  program_.setUniformValue("colour", QVector3D(colour.redF(), colour.greenF(), colour.blueF()));
  layout_.bind();
  gl->glDrawElements(GL_TRIANGLES, static_cast<int>(picture.mesh->triangles.size()), GL_UNSIGNED_INT,
                     nullptr);
  layout_.release();
  program_.release();
}

}  // namespace editor
