#include "renderer/job/camera_path.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <numeric>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "grf/wording.h"

namespace job {
namespace {

using options::NamedCamera;
using options::RenderOptions;
using transport::View;

const NamedCamera* find(const RenderOptions& render_options, const std::string& name) {
  const auto found = std::ranges::find(render_options.cameras, name, &NamedCamera::name);
  return found == render_options.cameras.end() ? nullptr : &*found;
}

bool is_path(const RenderOptions& render_options) { return render_options.camera_path != "turntable"; }

/// Rotates a vector about a unit axis by Rodrigues' formula.
grf::Vec3d rotated(const grf::Vec3d& vector, const grf::Vec3d& axis, double angle) {
  return vector * std::cos(angle) + axis.cross(vector) * std::sin(angle) +
         axis * (axis.dot(vector) * (1 - std::cos(angle)));
}

View turned(const View& view, double angle) {
  View result = view;
  const grf::Vec3d axis = grf::Vec3d(view.up).normalized();
  result.eye = view.target + rotated(view.eye - view.target, axis, angle);
  return result;
}

/// Interpolates between the second and third of four consecutive keys: linearly, or by a uniform Catmull-Rom
/// spline (Catmull and Rom 1974, "A class of local interpolating splines").
template <class Value>
Value between(const Value& before, const Value& from, const Value& to, const Value& after, double t,
              bool is_smooth) {
  using Number = decltype(from * 1.0);
  if (!is_smooth) return from * (1 - t) + to * t;
  const Number sum = from * 2.0 + (to - before) * t +
                     (before * 2.0 - from * 5.0 + to * 4.0 - after) * (t * t) +
                     (from * 3.0 - before - to * 3.0 + after) * (t * t * t);
  return sum * 0.5;
}

/// Keys before the first and after the last one continue in a straight line.
View along(const std::vector<NamedCamera>& cameras, double place, bool is_smooth) {
  const auto last = static_cast<double>(cameras.size() - 1);
  const auto segment = static_cast<std::ptrdiff_t>(std::min(std::floor(place), last - 1));
  const double t = place - static_cast<double>(segment);
  const auto value_at = [&](std::ptrdiff_t index, const auto& of) {
    const auto end = static_cast<std::ptrdiff_t>(cameras.size()) - 1;
    const auto at = [&](std::ptrdiff_t i) { return of(cameras[static_cast<std::size_t>(i)]); };
    if (index < 0) return at(0) * 2.0 - at(1);
    if (index > end) return at(end) * 2.0 - at(end - 1);
    return at(index);
  };
  const auto mixed = [&](const auto& of) {
    return between(value_at(segment - 1, of), value_at(segment, of), value_at(segment + 1, of),
                   value_at(segment + 2, of), t, is_smooth);
  };
  View view;
  view.eye = mixed([](const NamedCamera& camera) { return grf::Vec3d(camera.eye); });
  view.target = mixed([](const NamedCamera& camera) { return grf::Vec3d(camera.target); });
  view.up = grf::Vec3f(mixed([](const NamedCamera& camera) { return grf::Vec3d(camera.up).normalized(); }));
  const auto number = [&](float NamedCamera::*field) {
    return static_cast<float>(mixed([field](const NamedCamera& camera) { return double(camera.*field); }));
  };
  view.field_of_view = std::clamp(number(&NamedCamera::field_of_view), 0.01F, 179.99F);
  view.lens_radius = std::max(0.0F, number(&NamedCamera::lens_radius));
  view.focus_distance = static_cast<float>(std::max(
      0.0, mixed([](const NamedCamera& camera) { return double(focus_distance_of(view_of(camera))); })));
  return view;
}

}  // namespace

View view_of(const NamedCamera& camera) {
  View view;
  view.eye = grf::Vec3d(camera.eye);
  view.target = grf::Vec3d(camera.target);
  view.up = camera.up;
  view.field_of_view = camera.field_of_view;
  view.lens_radius = camera.lens_radius;
  view.focus_distance = camera.focus_distance;
  return view;
}

bool check_cameras(const RenderOptions& render_options, grf::Diagnostics& diagnostics) {
  if (!render_options.camera.empty() && find(render_options, render_options.camera) == nullptr) {
    std::vector<std::string> names;
    for (const NamedCamera& camera : render_options.cameras) names.push_back(camera.name);
    diagnostics.error(
        render_options.locations.of("BPT_Camera"),
        names.empty() ? fmt::format("there is no camera '{}': BPT_Cameras names none", render_options.camera)
                      : fmt::format("there is no camera '{}', expected one of {}", render_options.camera,
                                    fmt::join(names, ", ")));
    return false;
  }
  if (render_options.frames == 1) return true;
  if (render_options.frame > render_options.frames) {
    diagnostics.error(
        render_options.locations.of("BPT_Frame"),
        fmt::format("there is no frame {}: BPT_Frames is {}", render_options.frame, render_options.frames));
    return false;
  }
  if (is_path(render_options) && render_options.cameras.size() < 2) {
    diagnostics.error(render_options.locations.of("BPT_CameraPath"),
                      fmt::format("a camera path needs two cameras or more, and BPT_Cameras names {}",
                                  render_options.cameras.empty() ? "none" : "one"));
    return false;
  }
  return true;
}

View own_view(const RenderOptions& render_options, const grf::Box3d& bounds) {
  const float aspect =
      static_cast<float>(render_options.size.width) / static_cast<float>(render_options.size.height);
  View view = transport::view_of(bounds, render_options.field_of_view, aspect);
  if (render_options.eye) view.eye = *render_options.eye;
  if (render_options.target) view.target = *render_options.target;
  view.up = render_options.up;
  view.lens_radius = render_options.lens_radius;
  view.focus_distance = render_options.focus_distance.value_or(0);
  return view;
}

std::optional<View> named_view(const RenderOptions& render_options) {
  const NamedCamera* camera = find(render_options, render_options.camera);
  return camera == nullptr ? std::nullopt : std::optional(view_of(*camera));
}

View view_of_frame(const RenderOptions& render_options, const View& view) {
  if (render_options.frames == 1) return view;
  const double frame = std::max(0, render_options.frame - 1);
  if (!is_path(render_options)) return turned(view, 2 * std::numbers::pi * frame / render_options.frames);
  if (render_options.cameras.size() < 2) return view;
  const double place =
      frame / (render_options.frames - 1) * static_cast<double>(render_options.cameras.size() - 1);
  return along(render_options.cameras, place, render_options.camera_path == "smooth");
}

std::vector<int> frames_of(const RenderOptions& render_options) {
  if (render_options.frames == 1) return {};
  if (render_options.frame > 0) return {render_options.frame};
  std::vector<int> frames(static_cast<std::size_t>(render_options.frames));
  std::iota(frames.begin(), frames.end(), 1);
  return frames;
}

std::string file_of_frame(const std::string& path, int frame) {
  const std::filesystem::path whole(path);
  std::filesystem::path named = whole.parent_path() / whole.stem();
  named += fmt::format("_{:04}", frame) + whole.extension().string();
  return named.string();
}

}  // namespace job
