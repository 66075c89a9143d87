#include "converters/usd/usd_view.h"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "converters/renderers/render_view.h"
#include "converters/renderers/scene_folder.h"
#include "converters/text_encoding.h"
#include "converters/usd/exchange_material.h"
#include "grf/unique_names.h"
#include "renderer/options/op_file.h"

namespace convert {
namespace {

/// The focal length, in tenths of the scene's unit: 50 mm if that is a metre. Only its ratio to the aperture
/// decides the field of view, and with the f-number it gives the radius of the lens.
constexpr double FocalLength = 0.5;

void put_usd_camera(UsdText& text, const std::string& name, const std::string& original,
                    const RenderView& view, double reach) {
  std::vector<std::string> metadata;
  if (!original.empty()) {
    metadata = usd_custom_data(std::array{"string name = " + usd_string(to_utf8(original))});
  }
  text.begin(fmt::format("def Camera \"{}\"", name), metadata);
  const double vertical = 2 * FocalLength * std::tan(view.field_of_view * std::numbers::pi / 360);
  text.line("token projection = \"perspective\"");
  text.line("float focalLength = " + usd_number(FocalLength));
  text.line("float verticalAperture = " + usd_number(vertical));
  text.line("float horizontalAperture = " + usd_number(vertical * view.width / view.height));
  text.line(fmt::format("float2 clippingRange = ({}, {})", 1e-5 * reach, 10 * reach));
  text.line("float focusDistance = " + usd_number(view.focus_distance));
  // An f-number of 0 is a pinhole.
  const double f_number = view.lens_radius > 0 ? FocalLength / 10 / (2 * view.lens_radius) : 0;
  text.line("float fStop = " + usd_number(f_number));
  text.line("matrix4d xformOp:transform = " + usd_matrix(camera_to_world(view)));
  text.line("uniform token[] xformOpOrder = [\"xformOp:transform\"]");
  text.end();
}

/// Puts the light around the scene. Images of USD have +z in the centre and -x right of it, and ours -z and
/// +x.
bool put_usd_surroundings(UsdText& text, const std::string& path, RenderView& view,
                          grf::Diagnostics& diagnostics) {
  std::string file;
  if (view.surroundings) {
    SceneFolder folder(path, "usd");
    file = folder.add_image("environment", std::move(view.surroundings->image), diagnostics);
    if (file.empty()) return false;
  } else if (view.background == grf::Colour(0)) {
    return true;
  }
  text.begin("def DomeLight \"Surroundings\"");
  if (view.surroundings) {
    text.line("color3f inputs:color = (1, 1, 1)");
    text.line("float inputs:intensity = " + usd_number(view.surroundings->scale));
    text.line("asset inputs:texture:file = " + usd_asset(file));
    text.line("token inputs:texture:format = \"latlong\"");
    text.line(fmt::format("float xformOp:rotateY = {}", 180 + view.surroundings->rotation));
    text.line("uniform token[] xformOpOrder = [\"xformOp:rotateY\"]");
  } else {
    text.line("color3f inputs:color = " + usd_tuple(view.background));
    text.line("float inputs:intensity = 1");
  }
  text.end();
  return true;
}

/// Puts the cameras that have names; false after an error.
bool put_named_cameras(UsdText& text, options::RenderOptions render_options, const grf::Box3d& bounds,
                       grf::Diagnostics& diagnostics) {
  if (render_options.cameras.empty()) return true;
  grf::UniqueNames names;
  render_options.environment.clear();
  text.begin("def Scope \"Cameras\"");
  for (const options::NamedCamera& camera : render_options.cameras) {
    render_options.camera = camera.name;
    const auto view = render_view(render_options, bounds, diagnostics);
    if (!view) return false;
    put_usd_camera(text, names.take(to_prim_name(camera.name, "Camera")), camera.name, *view,
                   reach_from(view->eye, bounds));
  }
  text.end();
  return true;
}

}  // namespace

bool put_usd_view(UsdText& text, const std::string& parent, const std::string& path,
                  const WriteOptions& options, const grf::Box3d& bounds, Losses& losses,
                  grf::Diagnostics& diagnostics) {
  std::optional<options::RenderOptions> render_options;
  if (!options.op_file.empty()) {
    render_options = options::read_op_file(options.op_file, diagnostics);
    if (!render_options) return false;
  }
  if (bounds.isEmpty()) return true;
  auto view = render_view(render_options, bounds, diagnostics);
  if (!view) return false;
  if (view->has_backplate) losses.add(Loss::Backplate);
  put_usd_camera(text, "Camera", render_options ? render_options->camera : "", *view,
                 reach_from(view->eye, bounds));
  if (render_options && !put_named_cameras(text, *render_options, bounds, diagnostics)) return false;
  const std::vector<std::string> metadata = usd_custom_data(
      std::array{fmt::format("int depth = {}", view->depth), fmt::format("int samples = {}", view->samples)});
  text.begin("def RenderSettings \"Render\"", metadata);
  text.line(fmt::format("rel camera = <{}/Camera>", parent));
  text.line(fmt::format("uniform int2 resolution = ({}, {})", view->width, view->height));
  text.end();
  return put_usd_surroundings(text, path, *view, diagnostics);
}

}  // namespace convert
