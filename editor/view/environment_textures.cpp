#include "editor/view/environment_textures.h"

#include <cmath>
#include <vector>

#include "renderer/reflectance/shader.h"

namespace editor {
namespace {

constexpr int DirectionsSide = 64;
static_assert(DirectionsSide * DirectionsSide == studies::Environment::DrawnDirections);

}  // namespace

QByteArray environment_text() {
  return QByteArray::fromStdString(reflectance::shader_functions({})) +
         QByteArray::fromStdString(std::string(reflectance::shader_file("studio"))) +
         shader_text({"object_environment.glsl"});
}

QByteArray view_environment_preface(bool has_map) {
  return has_map ? "#define HAS_MAP\n" + environment_text() : QByteArray();
}

void EnvironmentTextures::load(const studies::Environment& sky, int most_side) {
  if (sky.map == loaded_) return;
  loaded_ = sky.map;
  const auto upload = [this](const GlObject& texture, int width, int height, GLint filter,
                             const std::vector<Imath::V4f>& values) {
    gl_.glActiveTexture(GL_TEXTURE0);
    gl_.glBindTexture(GL_TEXTURE_2D, texture.name());
    gl_.glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    gl_.glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, values.data());
    gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
    gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  };
  if (!sky.map || sky.map->image().width > most_side) return;
  const image::Image& image = sky.map->image();
  std::vector<Imath::V4f> texels;
  texels.reserve(image.pixels.size());
  for (const reflectance::Rgb& c : image.pixels) texels.emplace_back(c.x, c.y, c.z, sky.map->pdf_of(c));
  upload(map_, image.width, image.height, GL_LINEAR, texels);
  if (!sky.drawn) return;
  std::vector<Imath::V4f> directions;
  for (const reflectance::Vec3f& d : *sky.drawn) directions.emplace_back(d.x, d.y, d.z, 0.0F);
  upload(directions_, DirectionsSide, DirectionsSide, GL_NEAREST, directions);
}

void EnvironmentTextures::set(QOpenGLShaderProgram& program, const studies::Environment& sky,
                              GLuint first_unit) {
  program.setUniformValue("sky", static_cast<GLint>(sky.kind));
  program.setUniformValue("sky_scale", QVector3D(sky.scale.x, sky.scale.y, sky.scale.z));
  program.setUniformValue("sky_turn", std::cos(sky.turned), std::sin(sky.turned));
  program.setUniformValue("sky_is_drawn", sky.is_drawn());
  program.setUniformValue("sky_map", static_cast<GLint>(first_unit));
  program.setUniformValue("sky_directions", static_cast<GLint>(first_unit + 1));
  gl_.glActiveTexture(GL_TEXTURE0 + first_unit);
  gl_.glBindTexture(GL_TEXTURE_2D, map_.name());
  gl_.glActiveTexture(GL_TEXTURE0 + first_unit + 1);
  gl_.glBindTexture(GL_TEXTURE_2D, directions_.name());
}

}  // namespace editor
