#include "editor/tools/brdf_drawing.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <algorithm>
#include <cmath>

#include "editor/view/view_camera.h"
#include "renderer/studies/angles.h"

namespace editor {
namespace {

using reflectance::Rgb;
using reflectance::Vec3f;

constexpr std::size_t MostPrograms = 24;
/// Seconds of a draft: above and below, the next one has fewer or more pixels.
constexpr double TooLong = 0.04;
constexpr double MostlyFree = 0.8;  // of which a larger resolution may take so much
constexpr int LargestScale = 8;
constexpr int DraftSamples = 4;
/// Seconds of drawing per slice: a software rasteriser blocks everything else meanwhile, also the window.
constexpr double MostDrawing = 0.01;
constexpr int FewestRows = 8;
constexpr int FewestPasses = 8;
constexpr int MostPasses = 32;
constexpr int SamplesPerPass = 16;
constexpr std::size_t MostLights = 3;
/// Texture units.
constexpr GLuint NormalsUnit = 1;
constexpr GLuint RadianceUnit = 4;

double seconds(const QElapsedTimer& clock) { return static_cast<double>(clock.nsecsElapsed()) * 1e-9; }
QVector3D vector(const Vec3f& v) { return {v.x, v.y, v.z}; }
QVector3D rgb(const QColor& colour) { return {colour.redF(), colour.greenF(), colour.blueF()}; }

}  // namespace

BrdfDrawing::BrdfDrawing(Gl& gl, const GraphicsDriver& driver)
    : gl_(gl),
      driver_(driver),
      limits_(driver.limits()),
      no_vertices_(gl, GlKind::VertexArray),
      sky_(gl),
      normal_program_(
          editor::program_of(driver, "geometry.vert", {"shading_normal.glsl", "object_normals.frag"})),
      display_(editor::program_of(driver, "screen.vert", {"g_buffer.glsl", "object_display.frag"}, {},
                                  environment_text())) {}

void BrdfDrawing::show(const BrdfScene& scene) {
  const bool has_other_geometry = scene.object != scene_.object || scene.view.eye != scene_.view.eye ||
                                  scene.view.target != scene_.view.target || scene.size != scene_.size;
  if (has_other_geometry) normals_.reset();
  if (has_other_geometry) has_draft_normals_ = false;
  if (scene.size != scene_.size) {
    full_.reset();
    probe_.reset();
    draft_.reset();
    screen_.reset();
  }
  load(scene);
  passes_ = 0;
  row_ = 0;
  all_passes_ = std::clamp(scene_.samples() / SamplesPerPass, FewestPasses, MostPasses);
  if (scene_.object) draw_draft();
}

void BrdfDrawing::load(const BrdfScene& scene) {
  if (scene.object != scene_.object) {
    meshes_.clear();
    if (scene.object) {
      for (const ViewedObject::Part& part : scene.object->parts)
        meshes_.push_back(std::make_unique<MeshBuffers>(gl_, part.geometry->arrays()));
    }
  }
  scene_ = scene;
  sky_.load(scene_.lighting.environment, limits_.texture_side);
}

/// Returns the program of a BRDF; null if it has no shader. Programs are cached, since compiling is slow.
BrdfDrawing::Program* BrdfDrawing::program_of(const studies::LitBrdf& brdf) {
  const auto shader = reflectance::shader_of(brdf.brdf);
  if (!shader) return nullptr;
  if (programs_.size() > MostPrograms) programs_.clear();
  const auto [entry, is_new] = programs_.try_emplace(shader->text);
  if (is_new) {
    CompiledProgram made =
        driver_.compile({GlslVersion + shader_text({"screen.vert"}), fragment_text(shader->text)});
    entry->second = {std::move(made.program), made.log};
    was_compiled_ = true;
  }
  return &entry->second;
}

QByteArray BrdfDrawing::fragment_text(const std::string& brdf) {
  const std::string environment = shader_text({"object_environment.glsl"}).toStdString();
  return GlslVersion + QByteArray::fromStdString(reflectance::lit_surface_shader(brdf, environment)) +
         shader_text({"object_shade.frag"});
}

bool BrdfDrawing::is_by_glsl() {
  const auto& map = scene_.lighting.environment.map;
  if (map && map->image().width > limits_.texture_side) return false;
  const int split = scene_.split_column(scene_.size.width());
  for (int i = 0; i < 2; ++i) {
    if (i == 0 ? split == 0 : split == scene_.size.width()) continue;
    const Program* program = program_of(*scene_.brdfs[static_cast<std::size_t>(i)]);
    if (program == nullptr || program->program == nullptr) return false;
  }
  return true;
}

QStringList BrdfDrawing::limitations() {
  QStringList texts;
  const auto& map = scene_.lighting.environment.map;
  if (map && map->image().width > limits_.texture_side)
    texts +=
        tr("The environment map is larger than the graphics driver's textures, of %1 pixels: the object is "
           "shaded on the CPU, more slowly")
            .arg(limits_.texture_side);
  const int split = scene_.split_column(scene_.size.width());
  for (int i = 0; i < 2; ++i) {
    if (i == 0 ? split == 0 : split == scene_.size.width()) continue;
    const Program* program = program_of(*scene_.brdfs[static_cast<std::size_t>(i)]);
    if (program != nullptr && program->program == nullptr)
      texts += tr("The graphics driver cannot compile the shader of BRDF %1: it is shaded on the CPU, more "
                  "slowly: %2")
                   .arg(QChar('A' + i))
                   .arg(first_line(program->log));
  }
  return texts;
}

std::array<ShaderSource, 2> BrdfDrawing::sources() {
  std::array<ShaderSource, 2> sources;
  for (std::size_t i = 0; i < 2; ++i) {
    if (!scene_.brdfs[i]) continue;
    const auto shader = reflectance::shader_of(scene_.brdfs[i]->brdf);
    const Program* program = program_of(*scene_.brdfs[i]);
    if (!shader || program == nullptr) continue;
    sources[i] = {QString::fromUtf8(fragment_text(shader->text)),
                  program->program == nullptr ? program->log : QString()};
  }
  return sources;
}

void BrdfDrawing::draw_draft() {
  const auto size_at = [this](int scale) {
    return QSize((scene_.size.width() + scale - 1) / scale, (scene_.size.height() + scale - 1) / scale);
  };
  if (!draft_ || draft_->size() != size_at(scale_)) {
    draft_ = std::make_unique<BrdfLayers>(gl_, size_at(scale_));
    has_draft_normals_ = false;
  }
  is_by_glsl();  // compiles first, which is not part of what a draft takes
  const bool is_first = std::exchange(was_compiled_, false);
  QElapsedTimer clock;
  clock.start();
  const Pass pass = {0, std::min(DraftSamples, scene_.samples())};
  if (!has_draft_normals_) draw_normals(*draft_, pass);
  has_draft_normals_ = true;
  gl_.glFinish();
  const double for_normals = seconds(clock);
  draft_->clear_radiance();
  add(*draft_, pass, 0, draft_->size().height());
  gl_.glFinish();
  if (!is_first) adapt_scale(for_normals, seconds(clock) - for_normals + display_seconds_);
}

/// Adapts the resolution to the time that pixels take. The triangles of large objects take theirs at any.
void BrdfDrawing::adapt_scale(double for_normals, double for_pixels) {
  const double all = for_normals + for_pixels;
  if (all > TooLong && (scale_ < 2 || for_pixels > all / 3) && scale_ < LargestScale) {
    const double fitting = scale_ * std::sqrt(for_pixels / std::max(TooLong - for_normals, TooLong / 3));
    scale_ = std::clamp(static_cast<int>(std::lround(fitting)), scale_ + 1, LargestScale);
  } else if (scale_ > 1) {
    const double larger = static_cast<double>(scale_) / (scale_ - 1);
    if (for_normals * larger + for_pixels * larger * larger < MostlyFree * TooLong) --scale_;
  }
}

BrdfDrawing::Pass BrdfDrawing::pass(int number) const {
  const int count = scene_.samples() > 0 ? std::max(4, scene_.samples() / all_passes_ / 4 * 4) : 0;
  // R2 points fill the pixel evenly, the first at its centre.
  return {number * count,
          count,
          {std::fmod(0.5 + 0.7548776662 * number, 1) - 0.5, std::fmod(0.5 + 0.5698402910 * number, 1) - 0.5}};
}

void BrdfDrawing::draw_normals(BrdfLayers& layers, const Pass& pass) {
  const QSize size = layers.size();
  layers.begin_normals();
  gl_.glDisable(GL_BLEND);
  gl_.glEnable(GL_DEPTH_TEST);
  gl_.glDepthFunc(GL_LESS);
  gl_.glDepthMask(GL_TRUE);
  gl_.glClearColor(0, 0, 0, 0);
  gl_.glClearDepth(1);
  gl_.glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  const ViewCamera camera(scene_.view);
  const double aspect = scene_.aspect();
  grf::Matrix44d shift;
  shift[3][0] = -2 * pass.shift.x / size.width();
  shift[3][1] = -2 * pass.shift.y / size.height();
  const grf::Matrix44d world_to_camera = camera.world_to_camera();
  const grf::Matrix44d to_clip = camera.camera_to_clip(aspect, scene_.object->bounds) * shift;
  normal_program_->bind();
  normal_program_->setUniformValue("camera_to_world",
                                   to_qt(world_to_camera.inverse()).toGenericMatrix<3, 3>());
  for (std::size_t i = 0; i < meshes_.size(); ++i) {
    for (const grf::Matrix44d& to_world : scene_.object->parts[i].to_world) {
      const grf::Matrix44d to_camera = to_world * world_to_camera;
      normal_program_->setUniformValue("to_camera", to_qt(to_camera));
      normal_program_->setUniformValue("to_clip", to_qt(to_camera * to_clip));
      normal_program_->setUniformValue("normal_to_camera", to_qt(to_camera).normalMatrix());
      meshes_[i]->draw_triangles(0, scene_.object->parts[i].geometry->arrays().triangles.size(),
                                 VertexValue::Colour);
    }
  }
  gl_.glBindVertexArray(0);
}

void BrdfDrawing::set_camera(QOpenGLShaderProgram& program) {
  const ViewCamera camera(scene_.view);
  const double tangent = std::tan(camera.field_of_view() / 2 * studies::Degree);
  const double aspect = scene_.aspect();
  program.setUniformValue("view_forward", to_qt(camera.forward()));
  program.setUniformValue("view_right", to_qt(camera.right() * (tangent * aspect)));
  program.setUniformValue("view_up", to_qt(camera.up() * tangent));
}

void BrdfDrawing::cover() {
  gl_.glDisable(GL_DEPTH_TEST);
  gl_.glBindVertexArray(no_vertices_.name());
  gl_.glDrawArrays(GL_TRIANGLES, 0, 3);
  gl_.glBindVertexArray(0);
}

void BrdfDrawing::add(BrdfLayers& layers, const Pass& pass, int first_row, int rows) {
  if (!is_by_glsl()) return add_on_cpu(layers, pass, first_row, rows);
  const int width = layers.size().width();
  const int split = scene_.split_column(width);
  layers.begin_radiance();
  gl_.glEnable(GL_SCISSOR_TEST);
  gl_.glEnable(GL_BLEND);
  gl_.glBlendFunc(GL_ONE, GL_ONE);
  if (split > 0) {
    gl_.glScissor(0, first_row, split, rows);
    add_brdf(layers, *scene_.brdfs[0], pass);
  }
  if (split < width) {
    gl_.glScissor(split, first_row, width - split, rows);
    add_brdf(layers, *scene_.brdfs[1], pass);
  }
  gl_.glDisable(GL_BLEND);
  gl_.glDisable(GL_SCISSOR_TEST);
}

/// Adds the lights with the first part of the BRDF, and the environment with each.
void BrdfDrawing::add_brdf(BrdfLayers& layers, const studies::LitBrdf& brdf, const Pass& pass) {
  QOpenGLShaderProgram& program = *program_of(brdf)->program;
  program.bind();
  layers.bind_normals(NormalsUnit);
  program.setUniformValue("normals", static_cast<GLint>(NormalsUnit));
  program.setUniformValue("size", QSizeF(layers.size()));
  program.setUniformValue("shift", QPointF(pass.shift.x, pass.shift.y));
  program.setUniformValue("first_sample", pass.first);
  set_camera(program);
  set_environment(program);
  const auto& lights = scene_.lighting.lights;
  const std::size_t count = std::min(lights.size(), MostLights);
  std::array<QVector3D, MostLights> directions;
  std::array<QVector3D, MostLights> irradiance;
  for (std::size_t i = 0; i < count; ++i) {
    directions[i] = vector(lights[i].direction);
    irradiance[i] = vector(lights[i].irradiance);
  }
  program.setUniformValueArray("light_directions", directions.data(), static_cast<int>(MostLights));
  program.setUniformValueArray("light_irradiances", irradiance.data(), static_cast<int>(MostLights));
  const auto draw = [&](const reflectance::Brdf& part, const reflectance::SpecularTable& specular,
                        std::size_t light_count, int samples, float weight, float opacity) {
    const auto shader = reflectance::shader_of(part);
    program.setUniformValueArray("brdf_parameters", &shader->parameters[0].x,
                                 static_cast<int>(shader->parameters.size()), 3);
    program.setUniformValueArray("specular_weights", &specular[0].x, static_cast<int>(specular.size()), 3);
    program.setUniformValue("light_count", static_cast<GLint>(light_count));
    program.setUniformValue("samples", samples);
    program.setUniformValue("weight", weight);
    program.setUniformValue("opacity", opacity);
    cover();
  };
  // The lights are reflected by the whole BRDF, which is the first part unless that has no weight.
  const bool has_whole = !brdf.parts.empty() && brdf.parts.front().is_whole;
  draw(brdf.brdf, brdf.specular, count, has_whole ? pass.count : 0, has_whole ? brdf.parts.front().weight : 0,
       1);
  if (pass.count == 0) return;
  for (std::size_t i = has_whole ? 1 : 0; i < brdf.parts.size(); ++i) {
    const studies::EnvironmentPart& part = brdf.parts[i];
    draw(part.brdf, part.specular, 0, pass.count, part.weight, 0);
  }
}

void BrdfDrawing::refine(const std::function<bool()>& is_enough) {
  if (!scene_.object || passes_ >= all_passes_) return;
  if (!full_) full_ = std::make_unique<BrdfLayers>(gl_, scene_.size);
  const Pass now = pass(passes_);
  const int height = scene_.size.height();
  if (row_ == 0) {
    pass_seconds_ = 0;
    draw_normals(*full_, now);
    gl_.glFinish();
    if (passes_ == 0) {
      full_->clear_radiance();
      if (!normals_) read_normals();
    }
  }
  int rows = FewestRows;
  // At least some rows: on a slow machine the normals alone take a whole slice of time.
  do {
    QElapsedTimer clock;
    clock.start();
    rows = std::min(rows, height - row_);
    add(*full_, now, row_, rows);
    gl_.glFinish();
    row_ += rows;
    const double taken = seconds(clock);
    pass_seconds_ += taken;
    if (taken > MostDrawing) {
      rows = std::max(rows / 2, FewestRows);
    } else if (taken < MostDrawing / 3) {
      rows *= 2;
    }
  } while (row_ < height && !is_enough());
  if (row_ < height) return;
  row_ = 0;
  ++passes_;
  if (passes_ == 1) expect_drafts();
}

/// Prepares for the next draft by the time of a pass, which evaluates the BRDF more often at full resolution:
/// else the first frame of a movement would take long for costly BRDFs.
void BrdfDrawing::expect_drafts() {
  const auto lights = static_cast<double>(scene_.lighting.lights.size());
  const double evaluations = lights + pass(0).count;
  if (!(evaluations > 0)) return;
  const double full = pass_seconds_ * (lights + std::min(DraftSamples, pass(0).count)) / evaluations;
  const int fitting = static_cast<int>(std::lround(std::sqrt(full / TooLong)));
  scale_ = std::clamp(std::max(scale_, fitting), 1, LargestScale);
}

QImage BrdfDrawing::image() {
  QElapsedTimer clock;
  clock.start();
  // A draft is exposed at its own resolution, since that takes long, too.
  const BrdfLayers* layers = passes_ > 0 ? full_.get() : draft_.get();
  const QSize size = layers != nullptr ? layers->size() : scene_.size;
  if (!screen_ || screen_->size() != size) screen_ = std::make_unique<QOpenGLFramebufferObject>(size);
  screen_->bind();
  gl_.glViewport(0, 0, size.width(), size.height());
  gl_.glDisable(GL_BLEND);
  gl_.glDisable(GL_SCISSOR_TEST);
  gl_.glClearColor(scene_.background_top.redF(), scene_.background_top.greenF(),
                   scene_.background_top.blueF(), 1);
  gl_.glClear(GL_COLOR_BUFFER_BIT);
  if (layers != nullptr) display(*layers);
  QImage image(size, QImage::Format_RGB32);
  gl_.glPixelStorei(GL_PACK_ALIGNMENT, 4);
  gl_.glReadPixels(0, 0, image.width(), image.height(), GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, image.bits());
  image = std::move(image).mirrored();  // OpenGL's rows start at the bottom
  if (passes_ == 0) display_seconds_ = seconds(clock);
  return image;
}

void BrdfDrawing::display(const BrdfLayers& layers) {
  display_->bind();
  set_camera(*display_);
  set_environment(*display_);
  display_->setUniformValue("radiance", static_cast<GLint>(RadianceUnit));
  layers.bind_radiance(RadianceUnit);
  display_->setUniformValue("passes", static_cast<float>(std::max(1, passes_)));
  display_->setUniformValue("screen", QSizeF(layers.size()));
  display_->setUniformValue("gain", std::exp2(scene_.exposure));
  display_->setUniformValue("has_backdrop", scene_.has_backdrop);
  display_->setUniformValue("background_top", rgb(scene_.background_top));
  display_->setUniformValue("background_bottom", rgb(scene_.background_bottom));
  cover();
}

}  // namespace editor
