#pragma once

#include <QColor>
#include <memory>
#include <vector>

#include "editor/view/gl_objects.h"
#include "editor/view/view_camera.h"

namespace editor {

/// A line in world space, or in pixels from the upper left.
struct OverlayLine {
  grf::Vec3d from;
  grf::Vec3d to;
  QColor colour;
};

/// Lines with a common style.
struct OverlayLayer {
  std::vector<OverlayLine> lines;
  double width = 1;           ///< logical pixels
  double hidden_opacity = 0;  ///< opacity of occluded parts: 0 to 1
  bool is_flat = false;       ///< in pixels, in front of everything
};

/// Draws antialiased lines of constant screen width.
class OverlayPainter {
 public:
  struct Screen {
    grf::Vec2d size;  ///< logical pixels
    double pixel_ratio = 1;
  };

  OverlayPainter(Gl& gl, const GraphicsDriver& driver);

  void draw(const OverlayLayer& layer, const ViewCamera& camera, const grf::Box3d& bounds,
            const Screen& screen);

 private:
  void upload(const std::vector<OverlayLine>& lines, const grf::Matrix44d& to_camera);
  void draw_uploaded(const grf::Matrix44d& to_clip, const Screen& screen, double width, double opacity);

  Gl& gl_;
  std::unique_ptr<QOpenGLShaderProgram> program_;
  GlObject buffer_;
  GlObject vertex_array_;
  GLsizei vertices_ = 0;
};

}  // namespace editor
