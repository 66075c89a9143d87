// Renders the sphere with GLSL: a triangle covers the image, and its fragments intersect the sphere.
#include <QElapsedTimer>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <QOpenGLShaderProgram>
#include <QOpenGLVersionFunctionsFactory>
#include <QOpenGLVertexArrayObject>
#include <algorithm>
#include <map>

#include "editor/brdf/sphere_shading.h"
#include "editor/view/environment_textures.h"
#include "renderer/reflectance/shader.h"

namespace editor {
namespace {

constexpr std::size_t MostPrograms = 24;
/// Seconds of drawing per slice: a software rasteriser blocks everything else meanwhile, also the window.
constexpr double MostDrawing = 0.004;
constexpr int FewestRows = 4;

const char* const VertexText = R"(#version 330 core
void main() { gl_Position = vec4(4 * (gl_VertexID & 1) - 1, 2 * (gl_VertexID & 2) - 1, 0, 1); }
)";

const char* const MainText = R"(
uniform float side;
uniform float radius;
uniform int samples;
out vec4 result;
void main() {
  vec2 place = (gl_FragCoord.xy - vec2(side / 2)) / radius;
  float z2 = 1 - place.x * place.x - place.y * place.y;
  result = vec4(0, 0, 0, 1);
  if (z2 <= 0) return;
  normal = vec3(place, sqrt(z2));
  tangent = tangent_at(normal);
  bitangent = bitangent_at(normal);
  if (sky == 3) {
    float x = floor(gl_FragCoord.x);
    float y = side - 1 - floor(gl_FragCoord.y);  // rows from the top
    shift_a = part_above_floor(0.7548776662 * x + 0.5698402910 * y);
    shift_b = part_above_floor(0.8191725134 * x + 0.6710436067 * y);
  }
  vec3 u = to_local(vec3(0, 0, 1));
  result.rgb = reflected_radiance(u, 0, samples, 1) + specular_radiance(u);
}
)";

}  // namespace

struct SphereShader::Parts {
  const GraphicsDriver driver;
  const int most_side;  ///< of textures
  Gl* gl;
  EnvironmentTextures sky;
  std::unique_ptr<QOpenGLVertexArrayObject> no_vertices;
  std::unique_ptr<QOpenGLFramebufferObject> target;
  std::map<std::string, CompiledProgram> programs;
  QString compile_error;

  Parts(Gl& own_gl, const GraphicsDriver& own_driver)
      : driver(own_driver), most_side(own_driver.limits().texture_side), gl(&own_gl), sky(own_gl) {}

  /// Returns no program if the driver cannot compile the text. Programs are cached, since compiling is slow.
  const CompiledProgram& program_of(const std::string& brdf_text) {
    if (programs.size() > MostPrograms) programs.clear();
    const auto [entry, is_new] = programs.try_emplace(brdf_text);
    if (is_new) {
      const std::string text =
          reflectance::lit_surface_shader(brdf_text, shader_text({"object_environment.glsl"}).toStdString());
      entry->second = driver.compile(
          {VertexText, QByteArray("#version 330 core\n") + QByteArray::fromStdString(text) + MainText});
    }
    return entry->second;
  }

  void draw(QOpenGLShaderProgram& program, const SphereScene& scene, const reflectance::Shader& shader,
            int samples, const StopFlag& stop) {
    target->bind();
    gl->glViewport(0, 0, scene.side, scene.side);
    no_vertices->bind();
    program.bind();
    program.setUniformValue("side", static_cast<float>(scene.side));
    program.setUniformValue("radius", radius_of(scene.side));
    program.setUniformValue("light_count", 1);
    program.setUniformValue("light_directions", scene.light.x, scene.light.y, scene.light.z);
    program.setUniformValue("light_irradiances", scene.light_strength, scene.light_strength,
                            scene.light_strength);
    program.setUniformValue("samples", samples);
    sky.set(program, scene.environment, 0);
    const reflectance::SpecularTable specular = reflectance::specular_table(*scene.brdf);
    program.setUniformValueArray("specular_weights", &specular[0].x, static_cast<int>(specular.size()), 3);
    program.setUniformValueArray("brdf_parameters", &shader.parameters[0].x,
                                 static_cast<int>(shader.parameters.size()), 3);
    draw_by_bands(scene.side, stop);
    program.release();
  }

  void draw_by_bands(int side, const StopFlag& stop) {
    gl->glEnable(GL_SCISSOR_TEST);
    int rows = FewestRows;
    for (int row = 0; row < side && !stop.is_set();) {
      QElapsedTimer clock;
      clock.start();
      gl->glScissor(0, row, side, rows);
      gl->glDrawArrays(GL_TRIANGLES, 0, 3);
      gl->glFinish();
      row += rows;
      const double seconds = static_cast<double>(clock.nsecsElapsed()) * 1e-9;
      if (seconds > MostDrawing) {
        rows = std::max(rows / 2, FewestRows);
      } else if (seconds < MostDrawing / 4) {
        rows *= 2;
      }
    }
    gl->glDisable(GL_SCISSOR_TEST);
  }

  SphereImage read(int side) {
    std::vector<float> values(static_cast<std::size_t>(side * side) * 4);
    gl->glReadPixels(0, 0, side, side, GL_RGBA, GL_FLOAT, values.data());
    SphereImage image;
    image.side = side;
    image.is_by_glsl = true;
    for (int row = side - 1; row >= 0; --row) {  // OpenGL's rows start at the bottom
      for (int column = 0; column < side; ++column) {
        const float* c = &values[static_cast<std::size_t>(row * side + column) * 4];
        image.radiance.emplace_back(c[0], c[1], c[2]);
      }
    }
    return image;
  }
};

SphereShader::SphereShader(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
SphereShader::~SphereShader() = default;

const QString& SphereShader::compile_error() const { return parts_->compile_error; }

std::unique_ptr<SphereShader> SphereShader::create(QOpenGLContext& context, const GraphicsDriver& driver) {
  auto* gl = QOpenGLVersionFunctionsFactory::get<Gl>(&context);
  if (gl == nullptr) return nullptr;
  gl->initializeOpenGLFunctions();
  auto parts = std::make_unique<Parts>(*gl, driver);
  parts->no_vertices = std::make_unique<QOpenGLVertexArrayObject>();
  if (!parts->no_vertices->create()) return nullptr;
  return std::unique_ptr<SphereShader>(new SphereShader(std::move(parts)));
}

std::optional<SphereImage> SphereShader::shade(const SphereScene& scene, int samples, const StopFlag& stop) {
  const auto shader = reflectance::shader_of(*scene.brdf);
  parts_->compile_error.clear();
  const auto& map = scene.environment.map;
  if (!shader || (map && map->image().width > parts_->most_side)) return std::nullopt;
  parts_->sky.load(scene.environment, parts_->most_side);
  const CompiledProgram& made = parts_->program_of(shader->text);
  if (made.program == nullptr) {
    parts_->compile_error = first_line(made.log);
    return std::nullopt;
  }
  if (!parts_->target || parts_->target->width() != scene.side) {
    QOpenGLFramebufferObjectFormat format;
    format.setInternalTextureFormat(GL_RGBA32F);
    parts_->target = std::make_unique<QOpenGLFramebufferObject>(scene.side, scene.side, format);
    if (!parts_->target->isValid()) return std::nullopt;
  }
  parts_->draw(*made.program, scene, *shader, samples, stop);
  return parts_->read(scene.side);
}

}  // namespace editor
