#pragma once

#include <QImage>
#include <QOpenGLFramebufferObject>
#include <functional>
#include <memory>
#include <set>
#include <string>

#include "editor/view/overlay_painter.h"
#include "editor/view/view_pictures.h"
#include "editor/view/view_state.h"

namespace editor {

/// Draws what is to be seen in a view, and keeps on the graphics card what it draws from. It is made, used
/// and destroyed while its context is current.
class ViewDrawing {
 public:
  /// Throws ShaderRefused.
  ViewDrawing(Gl& gl, const GraphicsDriver& driver);

  /// From now on this is to be seen; there is a picture of it at once, perhaps a quick one.
  void show(const ViewState& state);
  const ViewState& state() const { return state_; }
  /// Makes the picture better, until there is something new to show or it is enough. Returns whether there
  /// is.
  bool work(const std::function<bool()>& is_enough) { return pictures_.work(is_enough); }

  bool is_full() const { return pictures_.is_full(); }
  bool is_done() const { return pictures_.is_done(); }
  /// Whether the full picture takes so long that it has to wait for the view to rest.
  bool is_slow() const { return pictures_.is_slow(); }
  /// Keywords of BRDFs that are shown as another one.
  const std::set<std::string>& not_shown() const { return scene_.surfaces().not_shown; }

  /// BRDF models whose shader the driver refuses, and why. They are shown by C++.
  const std::map<std::string, QString>& refused() const { return pictures_.refused(); }

  /// What there is, with the selection and what is drawn over it.
  QImage image();
  /// Makes the full picture first. See ViewPictures.
  std::vector<FacePixel> faces_in(const QRect& rectangle) { return pictures_.faces_in(rectangle); }

 private:
  void load(const ViewState& state);
  void compose();

  Gl& gl_;
  ViewState state_;
  SceneBuffers scene_;
  ViewPictures pictures_;
  OverlayPainter overlay_;
  GlObject no_vertices_;
  std::unique_ptr<QOpenGLShaderProgram> compose_;
  std::unique_ptr<QOpenGLFramebufferObject> screen_;
};

}  // namespace editor
