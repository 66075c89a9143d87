#pragma once

#include <QCoreApplication>
#include <QOpenGLFramebufferObject>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "editor/tools/brdf_layers.h"
#include "editor/tools/brdf_scene.h"
#include "editor/view/environment_textures.h"
#include "editor/view/mesh_buffers.h"
#include "renderer/reflectance/shader.h"

namespace editor {

/// Draws the BRDF viewer's object with GLSL: first a draft, then passes of it, each shifted by a part of a
/// pixel and with other directions of the environment. BRDFs without a shader, or whose shader the driver
/// cannot compile, are shaded on the CPU. It is created, used and destroyed while its context is current.
class BrdfDrawing {
  Q_DECLARE_TR_FUNCTIONS(editor::BrdfDrawing)

 public:
  /// Throws ShaderCompileError.
  BrdfDrawing(Gl& gl, const GraphicsDriver& driver);

  /// Sets what to draw, and draws a draft of it, at a lower resolution if it would take long.
  void show(const BrdfScene& scene);
  /// Works on the next pass, by some rows at least, until it is done or `is_enough`, which is asked after
  /// some milliseconds each.
  void refine(const std::function<bool()>& is_enough);
  int passes() const { return passes_; }
  int all_passes() const { return all_passes_; }
  int scale() const { return scale_; }

  /// Whether all that is visible is shaded with GLSL.
  bool is_by_glsl();
  /// Messages about what is not drawn as it should be, and why.
  QStringList limitations();
  /// The fragment shaders of both BRDFs.
  std::array<ShaderSource, 2> sources();
  /// The image as it is so far: the draft, which may be smaller, until a pass is done.
  QImage image();
  PixelProbe probe(const QPoint& pixel);
  /// The normals of the pixels' centres at full resolution; null until a pass is done.
  const std::shared_ptr<const NormalImage>& normals() const { return normals_; }

 private:
  static constexpr GLuint MapUnit = 2;  ///< texture unit, as is the next one

  /// A program with what the driver says about it.
  struct Program {
    std::unique_ptr<QOpenGLShaderProgram> program;
    QString log;
  };
  /// Directions of the environment, and where the object is seen.
  struct Pass {
    int first = 0;
    int count = 0;
    grf::Vec2d shift = grf::Vec2d(0);  ///< pixels, upwards
  };

  void load(const BrdfScene& scene);
  Program* program_of(const studies::LitBrdf& brdf);
  static QByteArray fragment_text(const std::string& brdf);
  void draw_draft();
  void adapt_scale(double for_normals, double for_pixels);
  void expect_drafts();
  void display(const BrdfLayers& layers);
  Pass pass(int number) const;
  void draw_normals(BrdfLayers& layers, const Pass& pass);
  void set_camera(QOpenGLShaderProgram& program);
  void set_environment(QOpenGLShaderProgram& program) {
    sky_.set(program, scene_.lighting.environment, MapUnit);
  }
  /// Adds rows of a pass to the radiance.
  void add(BrdfLayers& layers, const Pass& pass, int first_row, int rows);
  void add_brdf(BrdfLayers& layers, const studies::LitBrdf& brdf, const Pass& pass);
  void add_on_cpu(BrdfLayers& layers, const Pass& pass, int first_row, int rows);
  void cover();
  void read_normals();

  Gl& gl_;
  const GraphicsDriver driver_;
  const GraphicsLimits limits_;
  BrdfScene scene_;
  GlObject no_vertices_;
  EnvironmentTextures sky_;
  std::unique_ptr<QOpenGLShaderProgram> normal_program_, display_;
  std::map<std::string, Program> programs_;
  std::vector<std::unique_ptr<MeshBuffers>> meshes_;
  std::unique_ptr<BrdfLayers> full_, draft_, probe_;
  std::unique_ptr<QOpenGLFramebufferObject> screen_;
  std::shared_ptr<const NormalImage> normals_;
  double pass_seconds_ = 0;     ///< that shading the current pass took so far
  double display_seconds_ = 0;  ///< that displaying the last draft took
  bool has_draft_normals_ = false;
  bool was_compiled_ = false;  ///< since the last draft, which took the longer
  int scale_ = 1;              ///< of drafts
  int passes_ = 0;
  int all_passes_ = 1;
  int row_ = 0;  ///< of the pass that is being drawn
};

}  // namespace editor
