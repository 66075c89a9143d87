#include "converters/renderers/render_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "grf/framing.h"

namespace convert {
namespace {

using options::NamedCamera;
using options::RenderOptions;

/// The up vector is replaced by another axis where it is parallel to the view direction.
grf::Vec3d right_of(const grf::Vec3d& forward, const grf::Vec3d& up) {
  for (const grf::Vec3d& candidate : {up, grf::Vec3d(0, 0, 1), grf::Vec3d(1, 0, 0)}) {
    const grf::Vec3d right = forward.cross(candidate);
    if (right.length2() > 1e-10 * candidate.length2()) return right.normalized();
  }
  return {1, 0, 0};
}

/// Returns the camera of the options as if it had a name; framed where the options leave that open.
NamedCamera own_camera(const RenderOptions& render_options, const grf::Box3d& bounds) {
  const double aspect = double(render_options.size.width) / double(render_options.size.height);
  NamedCamera camera;
  camera.eye = render_options.eye.value_or(
      grf::Vec3f(grf::framing_eye(bounds, double(render_options.field_of_view), aspect)));
  camera.target =
      render_options.target.value_or(bounds.isEmpty() ? grf::Vec3f(0) : grf::Vec3f(bounds.center()));
  camera.up = render_options.up;
  camera.field_of_view = render_options.field_of_view;
  camera.lens_radius = render_options.lens_radius;
  camera.focus_distance = render_options.focus_distance.value_or(0);
  return camera;
}

std::optional<NamedCamera> camera_of(const RenderOptions& render_options, const grf::Box3d& bounds,
                                     grf::Diagnostics& diagnostics) {
  if (render_options.camera.empty()) return own_camera(render_options, bounds);
  const auto& cameras = render_options.cameras;
  const auto found = std::find_if(cameras.begin(), cameras.end(), [&](const NamedCamera& camera) {
    return camera.name == render_options.camera;
  });
  if (found != cameras.end()) return *found;
  diagnostics.error(render_options.locations.of("BPT_Camera"),
                    fmt::format("there is no camera '{}'", render_options.camera));
  return std::nullopt;
}

/// Places a camera; false after an error.
bool place(const NamedCamera& camera, const RenderOptions& render_options, RenderView& view,
           grf::Diagnostics& diagnostics) {
  view.eye = grf::Vec3d(camera.eye);
  const grf::Vec3d to_target = grf::Vec3d(camera.target) - view.eye;
  if (!(to_target.length() > 0)) {
    diagnostics.error(render_options.locations.of("BPT_VLook"), "the eye is at the point it looks at");
    return false;
  }
  view.forward = to_target.normalized();
  view.up = right_of(view.forward, grf::Vec3d(camera.up)).cross(view.forward);
  view.field_of_view = double(camera.field_of_view);
  view.lens_radius = double(camera.lens_radius);
  view.focus_distance = camera.focus_distance > 0 ? double(camera.focus_distance) : to_target.length();
  return true;
}

/// Reads the image around the scene; false after an error.
bool read_surroundings(const RenderOptions& render_options, RenderView& view, grf::Diagnostics& diagnostics) {
  if (render_options.environment.empty()) return true;
  view.has_backplate = render_options.projection == "backplate";
  if (view.has_backplate) return true;
  auto image = image::read_image(render_options.environment, diagnostics,
                                 render_options.locations.of("BPT_EM_Background"));
  if (!image) return false;
  for (grf::Colour& pixel : image->pixels) {
    for (int k = 0; k < 3; ++k) {
      if (!(pixel[k] >= 0) || !std::isfinite(pixel[k])) pixel[k] = 0;
    }
  }
  view.surroundings = {std::move(*image), render_options.environment_rotation,
                       render_options.environment_scale};
  return true;
}

}  // namespace

std::optional<RenderView> render_view(const std::optional<RenderOptions>& given, const grf::Box3d& bounds,
                                      grf::Diagnostics& diagnostics) {
  const RenderOptions render_options = given.value_or(RenderOptions());
  const auto camera = camera_of(render_options, bounds, diagnostics);
  RenderView view;
  if (!camera || !place(*camera, render_options, view, diagnostics)) return std::nullopt;
  view.width = render_options.size.width;
  view.height = render_options.size.height;
  view.samples = render_options.samples_per_pixel();
  view.depth = render_options.depth;
  view.background = render_options.background;
  if (!read_surroundings(render_options, view, diagnostics)) return std::nullopt;
  return view;
}

grf::Matrix44d camera_to_world(const RenderView& view) {
  const grf::Vec3d right = view.forward.cross(view.up);
  const grf::Vec3d& up = view.up;
  const grf::Vec3d& forward = view.forward;
  const grf::Vec3d& eye = view.eye;
  return {right.x,    right.y,    right.z,    0, up.x,  up.y,  up.z,  0,
          -forward.x, -forward.y, -forward.z, 0, eye.x, eye.y, eye.z, 1};
}

double reach_from(const grf::Vec3d& eye, const grf::Box3d& bounds) {
  return (eye - bounds.center()).length() + bounds.size().length() / 2;
}

}  // namespace convert
