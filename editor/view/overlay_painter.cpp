#include "editor/view/overlay_painter.h"

#include <QMatrix4x4>
#include <QVector2D>

namespace editor {
namespace {

constexpr int Floats = 7;  // of a vertex: position and colour

void add_vertex(const grf::Vec3d& position, const QColor& colour, std::vector<float>& vertices) {
  for (int i = 0; i < 3; ++i) vertices.push_back(static_cast<float>(position[i]));
  for (const float channel : {colour.redF(), colour.greenF(), colour.blueF(), colour.alphaF()}) {
    vertices.push_back(channel);
  }
}

}  // namespace

OverlayPainter::OverlayPainter(Gl& gl, const GraphicsDriver& driver)
    : gl_(gl),
      program_(program_of(driver, "overlay.vert", {"overlay.frag"}, "overlay.geom")),
      buffer_(gl, GlKind::Buffer),
      vertex_array_(gl, GlKind::VertexArray) {
  gl_.glBindVertexArray(vertex_array_.name());
  gl_.glBindBuffer(GL_ARRAY_BUFFER, buffer_.name());
  constexpr GLsizei Stride = Floats * sizeof(float);
  gl_.glEnableVertexAttribArray(0);
  gl_.glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, Stride, nullptr);
  gl_.glEnableVertexAttribArray(1);
  gl_.glVertexAttribPointer(1, 4, GL_FLOAT, GL_FALSE, Stride, gl_offset(3 * sizeof(float)));
  gl_.glBindVertexArray(0);
}

void OverlayPainter::upload(const std::vector<OverlayLine>& lines, const grf::Matrix44d& to_camera) {
  std::vector<float> vertices;
  vertices.reserve(2 * Floats * lines.size());
  for (const OverlayLine& line : lines) {
    add_vertex(line.from * to_camera, line.colour, vertices);
    add_vertex(line.to * to_camera, line.colour, vertices);
  }
  vertices_ = static_cast<GLsizei>(2 * lines.size());
  gl_.glBindBuffer(GL_ARRAY_BUFFER, buffer_.name());
  gl_.glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(float)), vertices.data(),
                   GL_STREAM_DRAW);
}

void OverlayPainter::draw_uploaded(const grf::Matrix44d& to_clip, const Screen& screen, double width,
                                   double opacity) {
  gl_.glEnable(GL_BLEND);
  gl_.glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE);
  program_->bind();
  program_->setUniformValue("to_clip", to_qt(to_clip));
  program_->setUniformValue("screen", QVector2D(static_cast<float>(screen.size.x * screen.pixel_ratio),
                                                static_cast<float>(screen.size.y * screen.pixel_ratio)));
  program_->setUniformValue("width", static_cast<float>(width * screen.pixel_ratio));
  program_->setUniformValue("opacity", static_cast<float>(opacity));
  program_->setUniformValue("nearer", ViewCamera::depth_offset(to_clip));
  gl_.glBindVertexArray(vertex_array_.name());
  gl_.glDrawArrays(GL_LINES, 0, vertices_);
  gl_.glDisable(GL_BLEND);
}

void OverlayPainter::draw(const OverlayLayer& layer, const ViewCamera& camera, const grf::Box3d& bounds,
                          const Screen& screen) {
  if (layer.lines.empty()) return;
  upload(layer.lines, layer.is_flat ? grf::Matrix44d() : camera.world_to_camera());
  const grf::Matrix44d pixels_to_clip = {
      2 / screen.size.x, 0, 0, 0, 0, -2 / screen.size.y, 0, 0, 0, 0, 1, 0, -1, 1, 0, 1};
  const grf::Matrix44d to_clip =
      layer.is_flat ? pixels_to_clip : camera.camera_to_clip(screen.size.x / screen.size.y, bounds);
  gl_.glDepthMask(GL_FALSE);
  gl_.glDisable(GL_DEPTH_TEST);
  const double hidden_opacity = layer.is_flat ? 1 : layer.hidden_opacity;
  if (hidden_opacity > 0) draw_uploaded(to_clip, screen, layer.width, hidden_opacity);
  if (!layer.is_flat) {
    gl_.glEnable(GL_DEPTH_TEST);
    gl_.glDepthFunc(GL_LEQUAL);
    draw_uploaded(to_clip, screen, layer.width, 1);
  }
  gl_.glDepthMask(GL_TRUE);
  gl_.glDisable(GL_DEPTH_TEST);
}

}  // namespace editor
