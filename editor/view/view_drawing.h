#pragma once

#include <QElapsedTimer>
#include <QImage>
#include <QOpenGLFramebufferObject>
#include <QStringList>
#include <functional>
#include <memory>
#include <vector>

#include "editor/view/overlay_painter.h"
#include "editor/view/picture_painter.h"
#include "editor/view/view_state.h"

namespace editor {

/// A face in a pixel: an index of a scene's instances and the face's number among those of all meshes.
struct FacePixel {
  std::uint32_t instance = 0;  ///< plus 1; 0: nothing
  std::uint32_t face = 0;
};

/// Draws what is to be seen in a view, and keeps on the graphics card what it draws from. While the view
/// changes there is a quick picture at once, and when it rests the full one follows, in slices of time; then
/// more of it, each moved by parts of a pixel, that smooth its edges. It is made, used and destroyed while
/// its context is current.
class ViewDrawing {
 public:
  /// Throws ShaderRefused.
  ViewDrawing(Gl& gl, const GraphicsDriver& driver);

  /// From now on this is to be seen, in no larger an image than the driver can draw; there is a picture of it
  /// at once, perhaps a quick one.
  void show(ViewState state);
  const ViewState& state() const { return state_; }
  /// Works on the full picture, until there is more to show or it is enough, which is asked after each step
  /// of some milliseconds. Returns whether there is more.
  bool work(const std::function<bool()>& is_enough);

  /// Whether the full picture is there, and whether nothing is left to improve.
  bool is_full() const { return passes_ > 0; }
  bool is_done() const { return passes_ == Passes; }
  /// Whether the full picture takes so long that it has to wait for the view to rest.
  bool is_slow() const { return is_slow_; }
  /// What is drawn otherwise than it should be, and why, in words.
  QStringList shortcomings() const;

  /// What there is, with the selection and what is drawn over it.
  QImage image();
  /// What is in the pixels of a rectangle of the full picture, from its lower left corner, row by row. That
  /// picture is made first, however long it takes.
  std::vector<FacePixel> faces_in(const QRect& rectangle);

 private:
  static constexpr int Passes = 8;

  void load(const ViewState& state);
  void restart();
  void prepare();
  void draw_quickly();
  void begin_pass();
  void accumulate();
  void compose();

  Gl& gl_;
  const GraphicsLimits limits_;
  ViewState state_;
  SceneBuffers scene_;
  PicturePainter painter_;
  OverlayPainter overlay_;
  GlObject no_vertices_;
  std::unique_ptr<QOpenGLShaderProgram> accumulate_, compose_;
  std::unique_ptr<GBuffer> full_, more_, quick_;
  std::unique_ptr<GlObject> sum_, sum_target_;
  std::unique_ptr<QOpenGLFramebufferObject> screen_;
  std::vector<PicturePainter::Step> steps_;
  std::size_t next_step_ = 0;
  int passes_ = 0;
  bool has_quick_ = false;
  bool is_slow_ = false;  // as the last full picture was
  double first_pass_seconds_ = 0;
  int quick_scale_ = 1;
};

}  // namespace editor
