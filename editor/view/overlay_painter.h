#pragma once

#include <QColor>
#include <memory>
#include <vector>

#include "editor/view/gl_objects.h"
#include "editor/view/view_camera.h"

namespace editor {

/// A line in the world, or in pixels from the upper left.
struct OverlayLine {
  grf::Vec3d from;
  grf::Vec3d to;
  QColor colour;
};

/// Lines that are drawn alike.
struct OverlayLayer {
  std::vector<OverlayLine> lines;
  double width = 1;           ///< pixels of the window
  double hidden_opacity = 0;  ///< of parts behind the scene: 0 to 1
  bool is_flat = false;       ///< in pixels, and in front of all
};

/// Draws smooth lines of one width on the screen.
class OverlayPainter {
 public:
  struct Screen {
    grf::Vec2d size;  ///< pixels of the window
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
