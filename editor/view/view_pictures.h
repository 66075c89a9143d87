#pragma once

#include <QElapsedTimer>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "editor/view/picture_painter.h"

namespace editor {

/// A face in a pixel: an index of a scene's instances and the face's number among those of all meshes.
struct FacePixel {
  std::uint32_t instance = 0;  ///< plus 1; 0: nothing
  std::uint32_t face = 0;
};

/// The pictures of a view. While it changes there is a quick one at once, and when it rests the full one
/// follows, in slices of time; then more of it, each moved by parts of a pixel, that smooth its edges.
class ViewPictures {
 public:
  ViewPictures(Gl& gl, const GraphicsDriver& driver, SceneBuffers& scene);

  /// What is to be seen, by pictures of this size in pixels.
  void request(const PictureRequest& request, const QSize& size);
  /// The scene is another one.
  void invalidate();
  /// What stands in for its meshes is.
  void invalidate_quick() { has_quick_ = false; }

  /// Makes that there is a picture for the request: the full one, if that is a matter of milliseconds.
  void prepare();
  /// Works on the full picture, until there is more to show or it is enough, which is asked after each step
  /// of some milliseconds. Returns whether there is more.
  bool work(const std::function<bool()>& is_enough);
  /// Makes the full picture, however long it takes.
  void finish_first_pass();

  /// Whether the full picture is there, and whether nothing is left to improve.
  bool is_full() const { return passes_ > 0; }
  bool is_done() const { return passes_ == Passes; }
  /// Whether the full picture takes so long that it has to wait for the view to rest.
  bool is_slow() const { return is_slow_; }

  /// Draws what there is into the framebuffer that is bound. The program is compose.frag.
  void bind_shown(QOpenGLShaderProgram& compose);

  /// BRDF models whose shader the driver refuses, and why. See PicturePainter.
  const std::map<std::string, QString>& refused() const { return painter_.refused(); }

  /// What is in the pixels of a rectangle of the full picture, from its lower left corner, row by row.
  std::vector<FacePixel> faces_in(const QRect& rectangle);

 private:
  static constexpr int Passes = 8;

  void paint_quick();
  void begin_pass();
  void accumulate();

  Gl& gl_;
  SceneBuffers& scene_;
  PicturePainter painter_;
  std::optional<PictureRequest> request_;
  QSize size_;
  std::unique_ptr<Picture> full_, more_, quick_;
  std::unique_ptr<GlObject> sum_, sum_target_;
  GlObject no_vertices_;
  std::unique_ptr<QOpenGLShaderProgram> accumulate_;
  std::vector<PicturePainter::Step> steps_;
  std::size_t next_step_ = 0;
  int passes_ = 0;
  bool has_quick_ = false;
  bool is_slow_ = false;  // as the last full picture was
  double first_pass_seconds_ = 0;
  int quick_scale_ = 1;
};

}  // namespace editor
