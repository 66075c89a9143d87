#pragma once

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QImage>
#include <QOpenGLFramebufferObject>
#include <QStringList>
#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "editor/view/frame_renderer.h"
#include "editor/view/overlay_painter.h"
#include "editor/view/view_state.h"

namespace editor {

/// The face in a pixel: an index of a scene's instances and the face's number among those of all meshes.
struct FacePixel {
  std::uint32_t instance = 0;  ///< plus 1; 0: background
  std::uint32_t face = 0;
};

/// Renders a view progressively, and owns its GPU data. While the view changes there is a draft at once; when
/// it rests the full image follows, in time slices, then further subpixel-shifted passes that antialias it.
/// It is created, used and destroyed while its context is current.
class ViewDrawing {
  Q_DECLARE_TR_FUNCTIONS(editor::ViewDrawing)

 public:
  /// Throws ShaderCompileError.
  ViewDrawing(Gl& gl, const GraphicsDriver& driver);

  /// Sets what to show, at a resolution within the driver's limits; an image is available at once, perhaps a
  /// draft.
  void show(ViewState state);
  const ViewState& state() const { return state_; }
  /// Works on the full image until it is done or `is_enough`, which is asked after each step of some
  /// milliseconds. Returns whether there is more to do.
  bool work(const std::function<bool()>& is_enough);

  /// Whether the full image is done, and whether it is fully antialiased.
  bool is_full() const { return passes_ > 0; }
  bool is_done() const { return passes_ == Passes; }
  /// Whether the full image is so slow that it has to wait for the view to rest.
  bool is_slow() const { return is_slow_; }
  /// Messages about what is not drawn as it should be, and why.
  QStringList limitations() const;

  /// The current image with selection and overlay.
  QImage image();
  /// The faces in a rectangle of pixels of the full image, from its lower left corner, row by row. That image
  /// is completed first, however long it takes.
  std::vector<FacePixel> faces_in(const QRect& rectangle);

 private:
  static constexpr int Passes = 8;

  void load(const ViewState& state);
  void restart();
  void prepare();
  void draw_draft();
  void begin_pass();
  void accumulate();
  void compose();
  void load_rendered();
  void load_plate();
  void set_background(QOpenGLShaderProgram& program);

  Gl& gl_;
  const GraphicsLimits limits_;
  ViewState state_;
  SceneBuffers scene_;
  FrameRenderer renderer_;
  OverlayPainter overlay_;
  GlObject no_vertices_;
  std::unique_ptr<QOpenGLShaderProgram> accumulate_;
  std::array<std::unique_ptr<QOpenGLShaderProgram>, 2> compose_;  // without and with a map
  std::unique_ptr<GBuffer> full_, more_, draft_;
  std::unique_ptr<GlObject> sum_, sum_target_;
  std::unique_ptr<QOpenGLFramebufferObject> screen_;
  std::unique_ptr<GlObject> rendered_;  // null: none
  std::unique_ptr<GlObject> plate_;     // likewise
  std::shared_ptr<const image::Image> loaded_plate_;
  std::vector<FrameRenderer::Step> steps_;
  std::size_t next_step_ = 0;
  int passes_ = 0;
  bool has_quick_ = false;
  bool is_slow_ = false;  // as the last full picture was
  double first_pass_seconds_ = 0;
  int quick_scale_ = 1;
};

}  // namespace editor
