#include "editor/view/frame_renderer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QMatrix4x4>

#include "editor/view/cpu_shading.h"
#include "renderer/reflectance/shader.h"

namespace editor {
namespace {

/// Number of triangles or edges per step.
constexpr std::size_t TrianglesPerStep = 20'000;
constexpr std::size_t EdgesPerStep = 12'000;
/// Rows of pixels per step of BRDF shading.
constexpr int BrdfRows = 32;
constexpr int RowsByCpp = 2;

grf::Matrix44d moved(const grf::Matrix44d& matrix, const grf::Vec2d& shift, const QSize& size) {
  return matrix * grf::Matrix44d().setTranslation(
                      grf::Vec3d(2 * shift.x / size.width(), 2 * shift.y / size.height(), 0));
}

bool has_faces(DisplayMode mode) { return mode != DisplayMode::Points && mode != DisplayMode::Wireframe; }

bool has_textures(DisplayMode mode) { return mode == DisplayMode::Textured || mode == DisplayMode::Brdf; }

/// Sky samples per pixel and pass.
int sky_samples(const FrameRequest& request) { return request.is_draft ? 4 : 8; }

QVector4D premultiplied(const QColor& colour) {
  const float a = colour.alphaF();
  return {colour.redF() * a, colour.greenF() * a, colour.blueF() * a, a};
}

}  // namespace

void set_shader_units(QOpenGLShaderProgram& program) {
  int unit = GBufferUnit;
  for (const char* name : {"faces", "normals", "values", "uvs", "depths", "light", "colours"}) {
    program.setUniformValue(name, unit++);
  }
  unit = TablesUnit;
  for (const char* name : {"selected", "surface_of_face", "surfaces", "terms"}) {
    program.setUniformValue(name, unit++);
  }
}

FrameRenderer::FrameRenderer(Gl& gl, const GraphicsDriver& driver)
    : gl_(gl),
      driver_(driver),
      most_side_(driver.limits().texture_side),
      no_vertices_(gl, GlKind::VertexArray),
      environment_(gl) {
  geometry_ = program_of(driver, "geometry.vert", {"shading_normal.glsl", "geometry.frag"});
  shade_ = program_of(driver, "screen.vert", {"g_buffer.glsl", "shade.frag"});
  texture_ = program_of(driver, "screen.vert", {"g_buffer.glsl", "texture.frag"});
  for (const bool has_map : {false, true}) {
    resolve_[has_map ? 1 : 0] = program_of(
        driver, "screen.vert", {"g_buffer.glsl", "sky.glsl", "view_environment.glsl", "resolve.frag"}, {},
        view_environment_preface(has_map));
  }
  lines_ = program_of(driver, "lines.vert", {"lines.frag"});
  normals_ = program_of(driver, "normals.vert", {"lines.frag"}, "normals.geom");
}

MeshBuffers* FrameRenderer::Job::mesh(std::size_t instance) const {
  const std::uint32_t mesh = scene.instances()[instance].mesh;
  return request.is_draft ? scene.proxy_mesh(mesh) : scene.mesh(mesh);
}

std::vector<FrameRenderer::Step> FrameRenderer::steps(SceneBuffers& scene, GBuffer& g_buffer,
                                                      const FrameRequest& request) {
  const auto job = std::make_shared<const Job>(Job{
      scene, g_buffer, request,
      moved(request.camera.camera_to_clip(request.aspect, request.bounds), request.shift, g_buffer.size())});
  std::vector<Step> steps;
  if (has_map(request)) environment_.load(request.environment->sky, most_side_);
  steps.emplace_back([this, job] { clear(*job); });
  for (Runs& runs : runs_of(*job, &MeshBuffers::triangle_count, TrianglesPerStep)) {
    steps.emplace_back([this, job, runs = std::move(runs)] { paint_geometry(*job, runs); });
  }
  const DisplayMode mode = request.style.mode;
  if (has_textures(mode)) steps.emplace_back([this, job] { paint_textures(*job); });
  if (mode == DisplayMode::Brdf) {
    add_brdf_steps(job, steps);
  } else if (has_faces(mode)) {
    steps.emplace_back([this, job] { shade(*job); });
  }
  add_line_steps(job, steps);
  return steps;
}

std::vector<FrameRenderer::Runs> FrameRenderer::runs_of(const Job& job,
                                                        std::size_t (MeshBuffers::*count)() const,
                                                        std::size_t size) {
  std::vector<Runs> all;
  std::size_t left = 0;
  for (std::size_t i = 0; i < job.scene.instances().size(); ++i) {
    const MeshBuffers* mesh = job.mesh(i);
    if (mesh == nullptr) continue;
    const std::size_t end = (mesh->*count)();
    for (std::size_t first = 0; first < end;) {
      if (left == 0) {
        all.emplace_back();
        left = size;
      }
      const std::size_t taken = std::min(left, end - first);
      all.back().push_back({i, first, taken});
      first += taken;
      left -= taken;
    }
  }
  return all;
}

void FrameRenderer::clear(const Job& job) {
  gl_.glDisable(GL_SCISSOR_TEST);
  gl_.glDisable(GL_BLEND);
  gl_.glDepthMask(GL_TRUE);
  job.g_buffer.begin(GBuffer::Target::Geometry);
  const std::array<GLuint, 4> nothing = {};
  const std::array<GLfloat, 1> far = {1};
  gl_.glClearBufferuiv(GL_COLOR, 0, nothing.data());
  gl_.glClearBufferfv(GL_DEPTH, 0, far.data());
  const std::array<GLfloat, 4> black = {};
  job.g_buffer.begin(GBuffer::Target::Light);
  gl_.glClearBufferfv(GL_COLOR, 0, black.data());
  job.g_buffer.begin(GBuffer::Target::Colour);
  gl_.glClearBufferfv(GL_COLOR, 0, black.data());
}

void FrameRenderer::paint_geometry(const Job& job, const Runs& runs) {
  job.g_buffer.begin(GBuffer::Target::Geometry);
  gl_.glEnable(GL_DEPTH_TEST);
  gl_.glDepthFunc(GL_LESS);
  gl_.glDisable(GL_BLEND);
  // Lines are drawn over faces.
  gl_.glEnable(GL_POLYGON_OFFSET_FILL);
  gl_.glPolygonOffset(0.5F, 1);
  const bool has_irradiance = job.request.style.mode == DisplayMode::Irradiance;
  geometry_->bind();
  geometry_->setUniformValue("face_of_triangle", 0);
  geometry_->setUniformValue("is_orthographic", job.request.camera.is_orthographic());
  geometry_->setUniformValue("has_irradiance", has_irradiance);
  paint_cut_out(job, [&] { paint_runs(job, runs); });
  gl_.glDisable(GL_POLYGON_OFFSET_FILL);
}

/// Paints what is left of faces: once, and once per texture whose alpha decides that, which is bound then.
void FrameRenderer::paint_cut_out(const Job& job, const std::function<void()>& paint) {
  const SurfaceTables& surfaces = job.scene.surfaces();
  set_shader_units(*geometry_);
  geometry_->setUniformValue("image", static_cast<GLint>(ImageUnit));
  geometry_->setUniformValue("alpha_number", surfaces.has_cutouts ? -1 : -2);
  if (!surfaces.has_cutouts) return paint();
  job.scene.bind_tables(TablesUnit);
  geometry_->setUniformValue("shift", QPointF(job.request.shift.x, job.request.shift.y));
  paint();
  for (const std::size_t number : surfaces.alphas) {
    geometry_->setUniformValue("alpha_number", static_cast<GLint>(number));
    job.scene.bind_texture(number, ImageUnit);
    paint();
  }
}

void FrameRenderer::paint_runs(const Job& job, const Runs& runs) {
  const bool has_irradiance = job.request.style.mode == DisplayMode::Irradiance;
  const grf::Matrix44d world_to_camera = job.request.camera.world_to_camera();
  for (const Run& run : runs) {
    const MeshInstance& instance = job.scene.instances()[run.instance];
    const grf::Matrix44d to_camera = instance.to_world * world_to_camera;
    geometry_->setUniformValue("to_camera", to_qt(to_camera));
    geometry_->setUniformValue("to_clip", to_qt(to_camera * job.camera_to_clip));
    geometry_->setUniformValue("normal_to_camera", to_qt(to_camera).normalMatrix());
    geometry_->setUniformValue("is_mirrored", instance.to_world.determinant() < 0);
    geometry_->setUniformValue("y_axis", to_qt(to_camera).mapVector(QVector3D(0, 1, 0)));
    geometry_->setUniformValue("first_triangle", static_cast<GLint>(run.first));
    geometry_->setUniformValue("instance", static_cast<GLint>(run.instance));
    geometry_->setUniformValue("first_face", static_cast<GLint>(job.scene.faces().first_face[instance.mesh]));
    job.mesh(run.instance)
        ->draw_triangles(run.first, run.count,
                         has_irradiance ? VertexValue::Irradiance : VertexValue::Colour);
  }
}

void FrameRenderer::cover(QOpenGLShaderProgram& program, const Job& job) {
  set_shader_units(program);
  job.g_buffer.bind_textures(GBufferUnit);
  job.scene.bind_tables(TablesUnit);
  gl_.glDisable(GL_DEPTH_TEST);
  gl_.glBindVertexArray(no_vertices_.name());
  gl_.glDrawArrays(GL_TRIANGLES, 0, 3);
}

void FrameRenderer::paint_textures(const Job& job) {
  gl_.glEnable(GL_BLEND);
  gl_.glBlendFunc(GL_ZERO, GL_SRC_COLOR);
  gl_.glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
  job.g_buffer.begin(GBuffer::Target::Values);
  texture_->bind();
  texture_->setUniformValue("image", static_cast<GLint>(ImageUnit));
  for (std::size_t i = 0; i < job.scene.surfaces().textures.size(); ++i) {
    texture_->setUniformValue("number", static_cast<GLint>(i));
    job.scene.bind_texture(i, ImageUnit);
    cover(*texture_, job);
  }
  gl_.glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl_.glDisable(GL_BLEND);
}

void FrameRenderer::shade(const Job& job) {
  const DisplayMode mode = job.request.style.mode;
  const bool is_coloured = mode == DisplayMode::Textured || mode == DisplayMode::VertexColours;
  job.g_buffer.begin(GBuffer::Target::Colour);
  gl_.glDisable(GL_BLEND);
  shade_->bind();
  shade_->setUniformValue("shading_mode", is_coloured ? 1 : mode == DisplayMode::Irradiance ? 2 : 0);
  shade_->setUniformValue("irradiance_scale", job.scene.faces().irradiance_scale);
  shade_->setUniformValue("clay", QVector3D(0.56F, 0.57F, 0.59F));
  cover(*shade_, job);
}

void FrameRenderer::add_line_steps(const SharedJob& job, std::vector<Step>& steps) {
  const ViewStyle& style = job->request.style;
  const bool uses_proxy = job->request.is_draft && job->scene.has_proxies();
  if (style.mode == DisplayMode::Points) steps.emplace_back([this, job] { paint_points(*job); });
  if (style.mode == DisplayMode::Wireframe || (style.mode == DisplayMode::SolidEdges && !uses_proxy)) {
    // A proxy has no polygons.
    if (!uses_proxy) {
      for (std::uint32_t mesh = 0; mesh < job->scene.faces().first_face.size(); ++mesh) {
        MeshBuffers* buffers = job->scene.mesh(mesh);
        if (buffers != nullptr && !buffers->has_edges()) buffers->set_edges(*job->scene.geometry(mesh));
      }
    }
    const auto count = uses_proxy ? &MeshBuffers::triangle_count : &MeshBuffers::edge_count;
    for (Runs& runs : runs_of(*job, count, EdgesPerStep)) {
      steps.emplace_back(
          [this, job, uses_proxy, runs = std::move(runs)] { paint_edges(*job, runs, uses_proxy); });
    }
  }
  if (uses_proxy) return;
  if (style.has_vertex_normals) steps.emplace_back([this, job] { paint_normals(*job, false); });
  if (style.has_face_normals) steps.emplace_back([this, job] { paint_normals(*job, true); });
}

void FrameRenderer::paint_edges(const Job& job, const Runs& runs, bool are_triangles) {
  const bool is_over_faces = job.request.style.mode == DisplayMode::SolidEdges;
  job.g_buffer.begin(GBuffer::Target::Colour);
  gl_.glDepthMask(GL_FALSE);
  gl_.glDepthFunc(GL_LEQUAL);
  is_over_faces ? gl_.glEnable(GL_DEPTH_TEST) : gl_.glDisable(GL_DEPTH_TEST);
  gl_.glEnable(GL_BLEND);
  gl_.glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  QColor colour = is_over_faces ? QColor(0x14, 0x15, 0x18) : job.request.style.lines;
  if (is_over_faces) colour.setAlphaF(0.75F);
  const grf::Matrix44d world_to_clip = job.request.camera.world_to_camera() * job.camera_to_clip;
  lines_->bind();
  lines_->setUniformValue("line_colour", premultiplied(colour));
  lines_->setUniformValue("nearer", ViewCamera::depth_offset(job.camera_to_clip));
  if (are_triangles) gl_.glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  for (const Run& run : runs) {
    const MeshInstance& instance = job.scene.instances()[run.instance];
    lines_->setUniformValue("to_clip", to_qt(instance.to_world * world_to_clip));
    MeshBuffers* mesh = job.mesh(run.instance);
    are_triangles ? mesh->draw_triangles(run.first, run.count, VertexValue::Colour)
                  : mesh->draw_edges(run.first, run.count);
  }
  gl_.glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  gl_.glDepthMask(GL_TRUE);
}

void FrameRenderer::paint_points(const Job& job) {
  job.g_buffer.begin(GBuffer::Target::Colour);
  gl_.glDisable(GL_DEPTH_TEST);
  gl_.glDisable(GL_BLEND);
  gl_.glEnable(GL_PROGRAM_POINT_SIZE);
  const grf::Matrix44d world_to_clip = job.request.camera.world_to_camera() * job.camera_to_clip;
  lines_->bind();
  lines_->setUniformValue("line_colour", premultiplied(job.request.style.lines));
  lines_->setUniformValue("nearer", 0.0F);
  lines_->setUniformValue("point_size", 3 * job.request.style.pixel_ratio);
  for (std::size_t i = 0; i < job.scene.instances().size(); ++i) {
    MeshBuffers* mesh = job.mesh(i);
    if (mesh == nullptr) continue;
    lines_->setUniformValue("to_clip", to_qt(job.scene.instances()[i].to_world * world_to_clip));
    mesh->draw_vertices();
  }
  gl_.glDisable(GL_PROGRAM_POINT_SIZE);
}

void FrameRenderer::paint_normals(const Job& job, bool of_faces) {
  job.g_buffer.begin(GBuffer::Target::Colour);
  gl_.glEnable(GL_DEPTH_TEST);
  gl_.glDepthFunc(GL_LEQUAL);
  gl_.glDepthMask(GL_FALSE);
  gl_.glDisable(GL_BLEND);
  QColor colour = job.request.style.normals;
  if (of_faces) colour = colour.lighter(150);
  normals_->bind();
  normals_->setUniformValue("line_colour", premultiplied(colour));
  normals_->setUniformValue("nearer", ViewCamera::depth_offset(job.camera_to_clip));
  normals_->setUniformValue("camera_to_clip", to_qt(job.camera_to_clip));
  const grf::Matrix44d world_to_camera = job.request.camera.world_to_camera();
  for (std::size_t i = 0; i < job.scene.instances().size(); ++i) {
    const MeshInstance& instance = job.scene.instances()[i];
    MeshBuffers* mesh = job.scene.mesh(instance.mesh);
    if (mesh == nullptr) continue;
    const MeshGeometry& geometry = *job.scene.geometry(instance.mesh);
    if (of_faces && !mesh->has_face_normals()) mesh->set_face_normals(geometry);
    const grf::Matrix44d to_camera = instance.to_world * world_to_camera;
    // About the length of an edge.
    const double faces = std::max(geometry.face_count(), 1U);
    const double scale = std::cbrt(std::abs(instance.to_world.determinant()));
    const double size = scale * grf::Box3d(geometry.bounds().min, geometry.bounds().max).size().length() /
                        std::max(4.0, std::sqrt(faces));
    normals_->setUniformValue("size", static_cast<float>(size));
    normals_->setUniformValue("to_camera", to_qt(to_camera));
    normals_->setUniformValue("normal_to_camera", to_qt(to_camera).normalMatrix());
    of_faces ? mesh->draw_faces_as_points() : mesh->draw_vertices();
  }
  gl_.glDepthMask(GL_TRUE);
}

void FrameRenderer::add_brdf_steps(const SharedJob& job, std::vector<Step>& steps) {
  for (const std::size_t model : job->scene.surfaces().models) {
    // A shader is compiled in the first step that needs it, so that other requests wait less.
    const auto made = brdfs_.find({model, has_map(job->request)});
    const int rows = made != brdfs_.end() && made->second == nullptr ? RowsByCpp : BrdfRows;
    for (int row = 0; row < job->g_buffer.size().height(); row += rows) {
      steps.emplace_back([this, job, model, row, rows] { paint_brdf(*job, model, row, rows); });
    }
  }
  steps.emplace_back([this, job] { resolve(*job); });
}

QOpenGLShaderProgram* FrameRenderer::brdf_program(const BrdfProgram& key) {
  const auto [model, has_map] = key;
  const auto [entry, is_new] = brdfs_.try_emplace(key);
  if (!is_new) return entry->second.get();
  const reflectance::FormulaShader shader = reflectance::formula_shader(
      model, [](std::size_t k) { return "parameter(" + std::to_string(k) + ")"; });
  QByteArray text = GlslVersion + shader_text({"g_buffer.glsl"}) +
                    QByteArray::fromStdString(shader.functions) + shader_text({"brdf_parameters.glsl"}) +
                    "vec3 model(vec3 u, vec3 v) { return through_layers(u, v) * " +
                    QByteArray::fromStdString(shader.call) + "; }\n";
  if (has_map) {
    text += "#define HAS_MAP\n" + QByteArray::fromStdString(std::string(reflectance::shader_file("studio"))) +
            shader_text({"object_environment.glsl"});
  }
  text += shader_text({"sky.glsl", "view_environment.glsl", "reflected_light.glsl", "brdf.frag"});
  CompiledProgram made = driver_.compile({GlslVersion + shader_text({"screen.vert"}), text});
  if (made.program == nullptr) failed_shaders_.emplace(shader.keyword, first_line(made.log));
  entry->second = std::move(made.program);
  return entry->second.get();
}

void FrameRenderer::set_eye(QOpenGLShaderProgram& program, const Job& job) {
  const ViewCamera& camera = job.request.camera;
  const double tangent = std::tan(camera.field_of_view() * std::numbers::pi / 360);
  program.setUniformValue("camera_to_world",
                          to_qt(camera.world_to_camera().inverse()).toGenericMatrix<3, 3>());
  program.setUniformValue("is_orthographic", camera.is_orthographic());
  program.setUniformValue("screen_size", QVector2D(static_cast<float>(job.g_buffer.size().width()),
                                                   static_cast<float>(job.g_buffer.size().height())));
  program.setUniformValue(
      "half_size", QVector2D(static_cast<float>(tangent * job.request.aspect), static_cast<float>(tangent)));
}

bool FrameRenderer::has_map(const FrameRequest& request) const {
  return request.style.mode == DisplayMode::Brdf && request.environment && request.environment->is_map() &&
         request.environment->sky.map->image().width <= most_side_;
}

void FrameRenderer::set_environment(QOpenGLShaderProgram& program, const FrameRequest& request) {
  const bool is_map = has_map(request);
  const SceneEnvironment none;
  const SceneEnvironment& environment = is_map ? *request.environment : none;
  if (is_map) environment_.set(program, environment.sky, EnvironmentUnit);
  const std::vector<reflectance::DistantLight> lights = environment.world_lights();
  std::array<QVector3D, studies::MostMapLights> directions;
  std::array<QVector3D, studies::MostMapLights> irradiance;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    directions[i] = to_qt(grf::Vec3d(lights[i].direction));
    irradiance[i] = to_qt(grf::Vec3d(lights[i].irradiance));
  }
  program.setUniformValueArray("light_directions", directions.data(), studies::MostMapLights);
  program.setUniformValueArray("light_irradiance", irradiance.data(), studies::MostMapLights);
  program.setUniformValue("light_count", static_cast<GLint>(lights.size()));
  program.setUniformValue("sky_limit", environment.limit());
  program.setUniformValue("headlight", is_map ? 0.0F : StudioHeadlight);
}

void FrameRenderer::paint_brdf(const Job& job, std::size_t model, int first_row, int rows) {
  QOpenGLShaderProgram* const made = brdf_program({model, has_map(job.request)});
  if (made == nullptr) return paint_brdf_by_cpp(job, model, first_row, rows);
  QOpenGLShaderProgram& program = *made;
  job.g_buffer.begin(GBuffer::Target::Light);
  gl_.glEnable(GL_SCISSOR_TEST);
  gl_.glScissor(0, first_row, job.g_buffer.size().width(), rows);
  gl_.glEnable(GL_BLEND);
  gl_.glBlendFunc(GL_ONE, GL_ONE);
  program.bind();
  program.setUniformValue("model_number", static_cast<GLint>(model));
  program.setUniformValue("sky_samples", sky_samples(job.request));
  program.setUniformValue("pass", job.request.pass);
  set_eye(program, job);
  set_environment(program, job.request);
  cover(program, job);
  gl_.glDisable(GL_BLEND);
  gl_.glDisable(GL_SCISSOR_TEST);
}

void FrameRenderer::paint_brdf_by_cpp(const Job& job, std::size_t model, int first_row, int rows) const {
  const FrameRequest& request = job.request;
  const int samples = sky_samples(request);
  const SceneEnvironment* environment = has_map(request) ? request.environment.get() : nullptr;
  const CpuShading light{model, samples, request.pass * samples, request.camera, request.aspect, environment};
  const int rows_left = job.g_buffer.size().height() - first_row;
  add_cpu_shading(light, job.scene.faces(), job.scene.surfaces(), job.g_buffer, first_row,
                  std::min(rows, rows_left));
}

void FrameRenderer::resolve(const Job& job) {
  job.g_buffer.begin(GBuffer::Target::Colour);
  gl_.glDisable(GL_BLEND);
  QOpenGLShaderProgram& program = *resolve_[has_map(job.request) ? 1 : 0];
  program.bind();
  program.setUniformValue("mirror_values", SurfaceTables::SpecularValues);
  set_eye(program, job);
  set_environment(program, job.request);
  cover(program, job);
}

}  // namespace editor
