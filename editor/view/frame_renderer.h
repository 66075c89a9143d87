#pragma once

#include <QColor>
#include <array>
#include <functional>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "editor/view/environment_textures.h"
#include "editor/view/g_buffer.h"
#include "editor/view/scene_buffers.h"
#include "editor/view/scene_environment.h"
#include "editor/view/view_camera.h"

namespace editor {

/// The display modes of the 3D view. Rendered is drawn as Solid, with an image of the renderer in its place
/// as far as there is one.
enum class DisplayMode {
  Points,
  Wireframe,
  Solid,
  SolidEdges,
  Textured,
  VertexColours,
  Irradiance,
  Brdf,
  Rendered
};

/// Display mode and colours of a view.
struct ViewStyle {
  DisplayMode mode = DisplayMode::Solid;
  bool has_vertex_normals = false;
  bool has_face_normals = false;
  QColor lines;           ///< edges and points
  QColor normals;         ///< normals drawn as lines
  float pixel_ratio = 1;  ///< device pixels per logical pixel

  bool operator==(const ViewStyle&) const = default;
};

/// The parameters of an image.
struct FrameRequest {
  ViewCamera camera;
  grf::Box3d bounds;  ///< of everything drawn
  ViewStyle style;
  double aspect = 1;
  /// Lights BRDFs, if it is a map, and is seen in mirrors and behind them; null: a studio does.
  std::shared_ptr<const SceneEnvironment> environment;
  bool is_draft = false;             ///< with proxy meshes and fewer light samples
  int pass = 0;                      ///< seed of the random numbers
  grf::Vec2d shift = grf::Vec2d(0);  ///< subpixel shift, pixels
};

/// Renders scenes into images in steps of at most some milliseconds each.
class FrameRenderer {
 public:
  using Step = std::function<void()>;

  /// Throws ShaderCompileError.
  FrameRenderer(Gl& gl, const GraphicsDriver& driver);

  /// The steps of a render, in order. Scene and G-buffer must outlive them.
  std::vector<Step> steps(SceneBuffers& scene, GBuffer& g_buffer, const FrameRequest& request);

  /// Whether an image shows an environment map.
  bool has_map(const FrameRequest& request) const;
  /// Sets the uniforms of view_environment.glsl for an image that was begun, in the bound program, which has
  /// a map if the image has.
  void set_environment(QOpenGLShaderProgram& program, const FrameRequest& request);

  /// BRDF models, by keyword, whose shader the driver cannot compile, and why. Their light is computed on the
  /// CPU.
  const std::map<std::string, QString>& failed_shaders() const { return failed_shaders_; }

 private:
  /// A range of the triangles or edges of an instance.
  struct Run {
    std::size_t instance = 0;
    std::size_t first = 0;
    std::size_t count = 0;
  };
  using Runs = std::vector<Run>;
  struct Job {
    SceneBuffers& scene;
    GBuffer& g_buffer;
    FrameRequest request;
    grf::Matrix44d camera_to_clip;

    MeshBuffers* mesh(std::size_t instance) const;
  };
  using SharedJob = std::shared_ptr<const Job>;
  /// The number of a model, and whether there is an environment map.
  using BrdfProgram = std::pair<std::size_t, bool>;

  static std::vector<Runs> runs_of(const Job& job, std::size_t (MeshBuffers::*count)() const,
                                   std::size_t size);
  void clear(const Job& job);
  void paint_geometry(const Job& job, const Runs& runs);
  void paint_cut_out(const Job& job, const std::function<void()>& paint);
  void paint_runs(const Job& job, const Runs& runs);
  void paint_textures(const Job& job);
  void shade(const Job& job);
  void add_brdf_steps(const SharedJob& job, std::vector<Step>& steps);
  void add_line_steps(const SharedJob& job, std::vector<Step>& steps);
  void paint_brdf(const Job& job, std::size_t model, int first_row, int rows);
  void paint_brdf_by_cpp(const Job& job, std::size_t model, int first_row, int rows) const;
  void resolve(const Job& job);
  void paint_edges(const Job& job, const Runs& runs, bool are_triangles);
  void paint_points(const Job& job);
  void paint_normals(const Job& job, bool of_faces);
  void cover(QOpenGLShaderProgram& program, const Job& job);
  void set_eye(QOpenGLShaderProgram& program, const Job& job);
  /// Null if the driver cannot compile it.
  QOpenGLShaderProgram* brdf_program(const BrdfProgram& key);

  Gl& gl_;
  const GraphicsDriver driver_;
  const int most_side_;  // of textures
  GlObject no_vertices_;
  EnvironmentTextures environment_;
  std::unique_ptr<QOpenGLShaderProgram> geometry_, shade_, texture_, lines_, normals_;
  std::array<std::unique_ptr<QOpenGLShaderProgram>, 2> resolve_;  // without and with a map
  std::map<BrdfProgram, std::unique_ptr<QOpenGLShaderProgram>> brdfs_;
  std::map<std::string, QString> failed_shaders_;
};

/// Sets the texture units of the tables in a program that starts with g_buffer.glsl.
void set_shader_units(QOpenGLShaderProgram& program);
/// The first texture units of G-buffers, of tables, of an image, and of a rendered image.
constexpr GLuint GBufferUnit = 0;
constexpr GLuint TablesUnit = 7;
constexpr GLuint ImageUnit = 11;
constexpr GLuint RenderedUnit = 12;
/// An environment map and its directions, and a backplate, have these texture units.
constexpr GLuint EnvironmentUnit = 13;
constexpr GLuint PlateUnit = 15;

}  // namespace editor
