#include "editor/document/render_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "editor/document/document.h"
#include "renderer/job/camera_path.h"

namespace editor {
namespace {

constexpr double SensorHeight = 24;  // mm

}  // namespace

transport::View own_camera(const Document& document) {
  return job::own_view(document.options().valid_options(), document.objects().bounds);
}

transport::View render_camera(const Document& document) {
  return job::named_view(document.options().valid_options()).value_or(own_camera(document));
}

void place_own_camera(options::RenderOptions& render_options, const transport::View& view) {
  render_options.eye = grf::Vec3f(view.eye);
  render_options.target = grf::Vec3f(view.target);
  render_options.up = view.up;
  render_options.field_of_view = view.field_of_view;
}

void place_render_camera(options::RenderOptions& render_options, const transport::View& view) {
  const auto selected =
      std::ranges::find(render_options.cameras, render_options.camera, &options::NamedCamera::name);
  if (selected == render_options.cameras.end()) return place_own_camera(render_options, view);
  transport::View placed = view;
  placed.lens_radius = selected->lens_radius;
  placed.focus_distance = selected->focus_distance;
  *selected = named_camera(selected->name, placed);
}

options::NamedCamera named_camera(std::string name, const transport::View& view) {
  return {std::move(name),    grf::Vec3f(view.eye), grf::Vec3f(view.target), view.up,
          view.field_of_view, view.lens_radius,     view.focus_distance};
}

double field_of_view_of(double focal_length) {
  return 2 * std::atan(SensorHeight / 2 / focal_length) * 180 / std::numbers::pi;
}

double focal_length_of(double field_of_view) {
  return SensorHeight / 2 / std::tan(field_of_view / 2 * std::numbers::pi / 180);
}

}  // namespace editor
