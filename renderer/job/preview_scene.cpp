#include "renderer/job/preview_scene.h"

#include <utility>

#include "grf/relocate.h"
#include "renderer/job/render_job.h"
#include "renderer/plan/plan.h"

namespace job {
namespace {

using grf::Diagnostics;
using transport::CompileSettings;
using transport::RenderSettings;

bool are_same(const PreviewRequest& a, const PreviewRequest& b) {
  return a.path == b.path && a.options == b.options && a.view == b.view && a.denoises == b.denoises &&
         a.region == b.region && a.scene == b.scene;
}

}  // namespace

std::optional<RenderSettings> PreviewScene::prepare(const PreviewRequest& request,
                                                    const std::stop_token& stop, Diagnostics& diagnostics) {
  auto compile_settings = compile_settings_of(request.options, diagnostics);
  if (!compile_settings) return std::nullopt;
  compile_settings->effects = request.options.effects();
  compile_settings->stop = stop;
  compile_settings->image_reader = reader_until(stop);
  const bool is_repeated = last_ && are_same(*last_, request);
  if (is_repeated || !can_reuse_compiled(request, *compile_settings)) {
    if (!compile(request, *compile_settings, diagnostics)) return std::nullopt;
  }
  RenderSettings settings = settings_of(request.options, compiled_->bounds());
  if (request.view) {
    transport::View view = *request.view;
    view.lens_radius = settings.view.lens_radius;
    view.focus_distance = settings.view.focus_distance;
    settings.view = view;
  }
  if (!has_sample_limit(request.options)) settings.samples = RenderSettings::Unlimited;
  if (!is_repeated) reuse_environment(request.options, settings);
  last_ = request;
  const bool has_environment =
      load_environment(request.options, settings, diagnostics, compile_settings->image_reader);
  environment_ = settings.integrator.environment;
  backplate_ = settings.backplate;
  const bool is_not_empty = has_geometry(*compiled_, request.options, diagnostics);
  if (!has_environment || !is_not_empty || !has_view_direction(settings.view, diagnostics))
    return std::nullopt;
  plan::keep_only(compile_settings->effects, settings);
  return settings;
}

image::ImageReader PreviewScene::reader_until(const std::stop_token& stop) const {
  if (!image_reader_) return image::read_image;
  return [this, stop](const std::string& path, Diagnostics& diagnostics,
                      const grf::SourceLocation& asked_for_at, image::Alpha alpha) {
    return image_reader_(path, diagnostics, asked_for_at, alpha, stop);
  };
}

bool PreviewScene::can_reuse_compiled(const PreviewRequest& request, const CompileSettings& settings) const {
  const CompileSettings& before = compile_settings_;
  return last_ && compiled_ && settings.scheme == before.scheme &&
         settings.missed_part == before.missed_part && settings.precision == before.precision &&
         settings.has_irradiance == before.has_irradiance && settings.effects == before.effects &&
         request.path == last_->path && request.scene == last_->scene;
}

bool PreviewScene::compile(const PreviewRequest& request, const CompileSettings& settings,
                           Diagnostics& diagnostics) {
  if (!check(request.scene, diagnostics)) return false;
  ++compilations_;
  auto compiled = transport::compile(grf::with_absolute_names(request.scene, request.path), diagnostics,
                                     settings, compiled_.get());
  if (!compiled) return false;
  compiled_ = std::make_shared<const transport::CompiledScene>(std::move(*compiled));
  compile_settings_ = settings;
  return true;
}

/// Reuses the environment map or backplate of the last request if this one has the same.
void PreviewScene::reuse_environment(const options::RenderOptions& render_options,
                                     RenderSettings& settings) const {
  const bool are_known = last_ && last_->options.environment == render_options.environment &&
                         last_->options.projection == render_options.projection &&
                         last_->options.environment_rotation == render_options.environment_rotation &&
                         last_->options.environment_scale == render_options.environment_scale;
  if (!are_known) return;
  settings.integrator.environment = environment_;
  settings.backplate = backplate_;
}

}  // namespace job
