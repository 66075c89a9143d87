#include <algorithm>
#include <cmath>

#include "renderer/image/image.h"
#include "renderer/reflectance/model.h"
#include "renderer/studies/angles.h"
#include "renderer/studies/brdf_viewer/tool.h"
#include "samples/shapes/shape.h"
#include "samples/shapes/teapot.h"

namespace studies {
namespace {

using Settings = BrdfViewerSettings;
using reflectance::in_unit;
using reflectance::number_parameter;
using reflectance::rgb_parameter;

constexpr int Triangles = 40'000;  // of a shape

reflectance::Parameter<Settings> azimuth_parameter(float Settings::*field, std::string_view name,
                                                   std::string_view help) {
  return in_unit("deg", number_parameter(field, name, -180, 180, help));
}

reflectance::Parameter<Settings> elevation_parameter(float Settings::*field, std::string_view name,
                                                     std::string_view help) {
  return in_unit("deg", number_parameter(field, name, -89, 89, help));
}

}  // namespace

reflectance::ModelTable<Settings> Settings::table() {
  using Self = Settings;
  using reflectance::boolean_parameter;
  using reflectance::whole;
  using reflectance::word_parameter;
  const auto light = [](Rgb Self::*field, std::string_view name) {
    return rgb_parameter(field, name, 0, 100,
                         "radiance of a white diffuse surface that faces the light; 0: the light is off");
  };
  constexpr std::string_view LightAzimuth = "azimuth of the light, from the z axis towards x";
  constexpr std::string_view LightElevation = "elevation of the light";
  return {
      .keyword = "brdfviewer",
      .title = "BRDF viewer",
      .parameters =
          {word_parameter(&Self::shape, "shape", {"sphere", "teapot", "knot", "model"},
                          "the object; `model` is that of the file. Anisotropic highlights run along the "
                          "parallels of a globe, not along the uv of a model"),
           azimuth_parameter(&Self::azimuth, "azimuth", "azimuth of the eye, from the z axis towards x"),
           elevation_parameter(&Self::elevation, "elevation", "elevation of the eye"),
           number_parameter(&Self::distance, "distance", 0.05F, 20,
                            "distance of the eye; at 1 the whole object is visible",
                            grf::ParameterScale::Logarithmic),
           number_parameter(&Self::split, "split", 0, 1,
                            "part of the width, from the left, that shows BRDF A; the rest shows B"),
           light(&Self::light1, "light1"),
           azimuth_parameter(&Self::azimuth1, "azimuth1", LightAzimuth),
           elevation_parameter(&Self::elevation1, "elevation1", LightElevation),
           light(&Self::light2, "light2"),
           azimuth_parameter(&Self::azimuth2, "azimuth2", LightAzimuth),
           elevation_parameter(&Self::elevation2, "elevation2", LightElevation),
           light(&Self::light3, "light3"),
           azimuth_parameter(&Self::azimuth3, "azimuth3", LightAzimuth),
           elevation_parameter(&Self::elevation3, "elevation3", LightElevation),
           word_parameter(&Self::sky, "sky", {"black", "constant", "studio", "map"},
                          "the environment; `map` is the image of the file"),
           rgb_parameter(&Self::radiance, "radiance", 0, 1000,
                         "radiance of the constant environment, and factor of the others"),
           azimuth_parameter(&Self::turned, "turned", "turns the environment about the y axis"),
           number_parameter(&Self::diffuseness, "diffuseness", 0, 4,
                            "scales the diffuse part of the environment's reflection: what kd adds"),
           number_parameter(&Self::specularity, "specularity", 0, 4,
                            "scales the other parts of the environment's reflection"),
           boolean_parameter(&Self::backdrop, "backdrop", "shows the environment behind the object"),
           number_parameter(&Self::exposure, "exposure", -10, 10,
                            "exposure in stops: each doubles the brightness"),
           whole(number_parameter(&Self::samples, "samples", 16, 4096,
                                  "directions of the environment per pixel, in which the BRDF is evaluated",
                                  grf::ParameterScale::Logarithmic))},
      .description =
          "Shows BRDFs on an object in real time, under lights and an environment: drag the light "
          "over the object, turn it, and compare two BRDFs."};
}

std::vector<reflectance::DistantLight> Settings::lights() const {
  std::vector<reflectance::DistantLight> all;
  const auto add = [&all](const Rgb& shown, float at_azimuth, float at_elevation) {
    if (!reflectance::is_black(shown))
      all.push_back({direction_at(at_azimuth, at_elevation), shown * reflectance::Pi});
  };
  add(light1, azimuth1, elevation1);
  add(light2, azimuth2, elevation2);
  add(light3, azimuth3, elevation3);
  return all;
}

int Settings::sample_count() const { return std::max(4, static_cast<int>(samples) / 4 * 4); }

transport::View Settings::view(const grf::Box3d& bounds, double aspect) const {
  return view_of_object(bounds, azimuth, elevation, distance, aspect);
}

Vec3f direction_at(double azimuth, double elevation) {
  const double a = azimuth * Degree;
  const double e = elevation * Degree;
  return Vec3f(grf::Vec3d(std::cos(e) * std::sin(a), std::sin(e), std::cos(e) * std::cos(a)));
}

Heading heading_of(const Vec3f& direction) {
  const double y = std::clamp<double>(direction.y, -1, 1);
  return {std::atan2(direction.x, direction.z) / Degree, std::asin(y) / Degree};
}

bool is_environment_map(const std::string& path) {
  for (const std::string_view extension : {"exr", "hdr", "pic", "pfm"}) {
    if (image::has_extension(path, extension)) return true;
  }
  return false;
}

std::optional<ViewerFiles> files_of(const ToolState& state, grf::Diagnostics& diagnostics) {
  ViewerFiles files;
  for (const ToolState::File& file : state.files) {
    const bool is_environment = is_environment_map(file.path);
    const ToolState::File*& place = is_environment ? files.environment : files.model;
    if (place != nullptr) {
      diagnostics.error(file.location, std::string("the BRDF viewer shows one ") +
                                           (is_environment ? "environment map" : "model") +
                                           " at a time: remove '" + place->path + "' or '" + file.path + "'");
      return std::nullopt;
    }
    place = &file;
  }
  return files;
}

grf::Scene scene_of_shape(int shape) {
  constexpr int Subdivisions = 24;  // about as many triangles as of the others
  grf::Mesh mesh = shape == Settings::Teapot ? shape::teapot(Subdivisions)
                   : shape == Settings::Knot ? shape::knot(Triangles)
                                             : shape::sphere(Triangles);
  grf::Scene scene;
  grf::Block block;
  block.content = grf::Shared<grf::Mesh>(std::move(mesh));
  scene.contents.blocks.push_back(std::move(block));
  return scene;
}

}  // namespace studies
