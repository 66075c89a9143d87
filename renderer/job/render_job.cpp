#include "renderer/job/render_job.h"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include "grf/check.h"
#include "grf/read.h"
#include "grf/relocate.h"
#include "grf/write.h"
#include "renderer/bake/baked_scene.h"
#include "renderer/image/image.h"
#include "renderer/job/camera_path.h"
#include "renderer/options/scheme_model.h"
#include "renderer/reflectance/scheme.h"

namespace job {
namespace {

using grf::Diagnostics;
using options::RenderOptions;
using transport::CompiledScene;
using transport::Integrator;
using transport::PixelSampling;

/// Sets the sampling scheme that the options name, checked; returns false after an error.
bool override_scheme(const RenderOptions& render_options, transport::CompileSettings& settings,
                     Diagnostics& diagnostics) {
  options::warn_of_unused_options(render_options, diagnostics);
  auto model = options::scheme_model(render_options);
  if (!model) return true;
  if (!grf::check(*model, reflectance::scheme_infos(), "PDF", diagnostics)) return false;
  settings.scheme = {std::move(*model), render_options.factors_file};
  return true;
}

Integrator integrator_of(const RenderOptions& render_options) {
  if (render_options.ray_casting) return Integrator::Normals;
  return render_options.integrator == "naive" ? Integrator::Naive : Integrator::Path;
}

}  // namespace

std::optional<grf::Scene> read_scene(const RenderOptions& render_options, Diagnostics& diagnostics) {
  auto scene = grf::read(render_options.scene, diagnostics);
  if (!scene || !check(*scene, diagnostics)) return std::nullopt;
  return scene;
}

bool check(const grf::Scene& scene, Diagnostics& diagnostics) {
  return grf::check(scene, reflectance::catalogue(), diagnostics);
}

bool has_sample_limit(const RenderOptions& render_options) {
  return render_options.samples || (!render_options.target_error && !render_options.max_seconds);
}

std::optional<transport::CompileSettings> compile_settings_of(const RenderOptions& render_options,
                                                              Diagnostics& diagnostics) {
  transport::CompileSettings settings;
  settings.threads = render_options.threads;
  if (render_options.image_reader.read) settings.image_reader = render_options.image_reader.read;
  settings.has_irradiance = render_options.uses_irradiance;
  if (integrator_of(render_options) == Integrator::Naive) {
    settings.missed_part = reflectance::MissedPart::Missing;
  }
  if (render_options.precision == "double") settings.precision = reflectance::Precision::Double;
  if (!override_scheme(render_options, settings, diagnostics)) return std::nullopt;
  return settings;
}

bool load_environment(const RenderOptions& render_options, transport::RenderSettings& settings,
                      Diagnostics& diagnostics) {
  const image::ImageReader& read = render_options.image_reader.read;
  return load_environment(render_options, settings, diagnostics, read ? read : image::read_image);
}

bool load_environment(const RenderOptions& render_options, transport::RenderSettings& settings,
                      Diagnostics& diagnostics, const image::ImageReader& image_reader) {
  const std::string& path = render_options.environment;
  if (path.empty()) return true;
  const grf::SourceLocation location = render_options.locations.of("BPT_EM_Background");
  const auto read_scaled = [&](const std::string& file, Diagnostics& messages,
                               const grf::SourceLocation& asked_for_at, image::Alpha alpha) {
    auto image = image_reader(file, messages, asked_for_at, alpha);
    if (image && render_options.environment_scale != 1) {
      for (reflectance::Rgb& pixel : image->pixels) pixel *= render_options.environment_scale;
    }
    return image;
  };
  if (render_options.projection == "backplate") {
    if (settings.backplate) return true;
    auto image = read_scaled(path, diagnostics, location, image::Alpha::OverBlack);
    if (image) settings.backplate = std::make_shared<const image::Image>(std::move(*image));
    return settings.backplate != nullptr;
  }
  if (render_options.resampling) {
    settings.integrator.resampling = {render_options.resampling->first, render_options.resampling->second};
  }
  if (settings.integrator.environment) return true;
  auto map = transport::read_environment_map(path, diagnostics, location, read_scaled,
                                             render_options.environment_rotation,
                                             transport::EnvironmentMap::Weights::Compensated);
  if (!map) return false;
  settings.integrator.environment = std::make_shared<const transport::EnvironmentMap>(std::move(*map));
  return true;
}

namespace {

/// Sets the number of samples and their pattern in a pixel.
void set_pixel_samples(const RenderOptions& render_options, transport::RenderSettings& settings) {
  settings.samples = render_options.samples_per_pixel();
  if (settings.integrator.integrator == Integrator::Path) return;
  settings.pixel_sampling = PixelSampling::Centre;
  if (settings.integrator.integrator == Integrator::Normals) {
    settings.samples = 1;
    return;
  }
  const auto [columns, rows] = render_options.pixel_samples;
  settings.samples = columns * rows;
  settings.grid_columns = columns;
  if (render_options.pixel_random) settings.pixel_sampling = PixelSampling::Sobol;
  if (render_options.pixel_radial) settings.pixel_sampling = PixelSampling::Regular;
}

}  // namespace

transport::RenderSettings settings_of(const RenderOptions& render_options, const grf::Box3d& bounds) {
  transport::RenderSettings settings;
  settings.width = render_options.size.width;
  settings.height = render_options.size.height;
  settings.view =
      view_of_frame(render_options, named_view(render_options).value_or(own_view(render_options, bounds)));
  settings.integrator.background = render_options.background;
  settings.integrator.depth = render_options.depth;
  settings.integrator.split_count = render_options.split_count;
  settings.integrator.uses_irradiance = render_options.uses_irradiance;
  settings.integrator.measures_sampling = render_options.writes_sampling_time;
  settings.integrator.integrator = integrator_of(render_options);
  settings.integrator.secondary_rays =
      render_options.secondary_rays_root * render_options.secondary_rays_root;
  settings.integrator.uses_full_kernel = render_options.kernel == "full";
  set_pixel_samples(render_options, settings);
  settings.adaptive = render_options.adaptive;
  settings.target_error = render_options.target_error;
  settings.max_seconds = render_options.max_seconds;
  if (render_options.points == "independent") settings.pattern = transport::SamplePattern::Independent;
  settings.seed = render_options.seed;
  settings.threads = render_options.threads;
  return settings;
}

namespace {

bool has_backplate(const RenderOptions& render_options) {
  return !render_options.environment.empty() && render_options.projection == "backplate";
}

plan::PlanSettings plan_settings_of(const RenderOptions& render_options,
                                    const transport::RenderSettings& settings) {
  plan::PlanSettings plan;
  plan.limits = {settings.view, settings.width, settings.height, settings.integrator.depth,
                 render_options.effects()};
  plan.draws_normals = settings.integrator.integrator == Integrator::Normals;
  plan.has_backplate = has_backplate(render_options);
  plan.has_environment = !render_options.environment.empty() && !plan.has_backplate;
  plan.has_background = !reflectance::is_black(settings.integrator.background);
  plan.uses_irradiance = render_options.uses_irradiance;
  plan.keeps_all = render_options.kernel == "full";
  for (const char* layer : {"albedo", "normal", "depth"}) {
    const auto& layers = render_options.layers;
    plan.shows_surfaces |= std::find(layers.begin(), layers.end(), layer) != layers.end();
  }
  return plan;
}

}  // namespace

std::optional<RenderPlan> render_plan(const grf::Scene& scene, transport::CompileSettings compile_settings,
                                      const RenderOptions& render_options, Diagnostics& diagnostics) {
  compile_settings.effects = render_options.effects();
  const plan::CoarseScene coarse_scene(scene, transport::most_copied_triangles(compile_settings));
  transport::RenderSettings settings = settings_of(render_options, coarse_scene.bounds);
  if (!check_cameras(render_options, diagnostics) || !has_view_direction(settings.view, diagnostics))
    return std::nullopt;
  plan::PlanSettings plan_settings = plan_settings_of(render_options, settings);
  if (compile_settings.scheme && compile_settings.scheme->brdf.empty())
    plan_settings.scheme = to_text(compile_settings.scheme->model);
  plan::Plan plan = plan::plan_of(coarse_scene, plan_settings);
  follow(plan, settings);
  compile_settings.effects = plan.needed();
  compile_settings.reflecting = plan.reflecting;
  return RenderPlan{std::move(compile_settings), std::move(settings), std::move(plan)};
}

bool has_view_direction(const transport::View& view, Diagnostics& diagnostics) {
  if (view.eye != view.target) return true;
  diagnostics.error({}, "BPT_Viewer and BPT_VLook are the same point: the view direction is undefined");
  return false;
}

bool load_environment(const RenderOptions& render_options, RenderPlan& planned, Diagnostics& diagnostics) {
  const bool is_needed =
      planned.plan[transport::Effect::Environment].is_needed ||
      (has_backplate(render_options) && planned.plan[transport::Effect::Background].is_needed);
  if (is_needed) return load_environment(render_options, planned.settings, diagnostics);
  planned.settings.integrator.environment = nullptr;
  planned.settings.backplate = nullptr;
  return true;
}

bool has_geometry(const CompiledScene& scene, const RenderOptions& render_options, Diagnostics& diagnostics) {
  if (scene.triangle_count() > 0) return true;
  diagnostics.error(grf::whole_file(render_options.scene),
                    "the scene has nothing to render: it needs a mesh or a light");
  return false;
}

namespace {

/// Makes the job of a scene and settings, either of which may be missing after an error.
std::optional<RenderJob> job_of(std::optional<grf::Scene> scene,
                                const std::optional<transport::CompileSettings>& compile_settings,
                                const RenderOptions& render_options, Diagnostics& diagnostics) {
  std::optional<RenderPlan> planned;
  if (scene && compile_settings)
    planned = render_plan(*scene, *compile_settings, render_options, diagnostics);
  if (!planned) {
    transport::RenderSettings unused;
    load_environment(render_options, unused, diagnostics);  // to report all errors at once
    return std::nullopt;
  }
  auto compiled = transport::compile(*std::move(scene), diagnostics, planned->compile_settings);
  const bool is_not_empty = compiled && has_geometry(*compiled, render_options, diagnostics);
  if (!load_environment(render_options, *planned, diagnostics) || !is_not_empty) return std::nullopt;
  if (!has_sample_limit(render_options)) planned->settings.samples = transport::RenderSettings::Unlimited;
  return RenderJob{std::move(*compiled), std::move(planned->settings), std::move(planned->plan)};
}

}  // namespace

std::optional<RenderJob> render_job(const RenderOptions& render_options, Diagnostics& diagnostics,
                                    const std::optional<transport::SchemeOverride>& scheme) {
  auto compile_settings = compile_settings_of(render_options, diagnostics);
  if (compile_settings && !compile_settings->scheme) compile_settings->scheme = scheme;
  return job_of(read_scene(render_options, diagnostics), compile_settings, render_options, diagnostics);
}

std::optional<RenderJob> render_job(grf::Scene scene, const RenderOptions& render_options,
                                    Diagnostics& diagnostics) {
  const auto compile_settings = compile_settings_of(render_options, diagnostics);
  if (!check(scene, diagnostics)) return std::nullopt;
  return job_of(std::move(scene), compile_settings, render_options, diagnostics);
}

std::optional<BakeJob> bake_job(RenderOptions render_options, int directions, Diagnostics& diagnostics) {
  render_options.uses_irradiance = false;
  render_options.ray_casting = false;
  render_options.integrator = "path";
  const auto compile_settings = compile_settings_of(render_options, diagnostics);
  auto scene = read_scene(render_options, diagnostics);
  if (!scene || !compile_settings) return std::nullopt;
  *scene = grf::flatten(*scene, render_options.scene);
  if (!bake::has_few_copies(*scene, diagnostics)) return std::nullopt;
  auto compiled = transport::compile(*scene, diagnostics, bake::without_instances(*compile_settings));
  if (!compiled) return std::nullopt;
  transport::RenderSettings render_settings = settings_of(render_options, compiled->bounds());
  if (!load_environment(render_options, render_settings, diagnostics)) return std::nullopt;
  bake::BakeSettings settings;
  settings.integrator = render_settings.integrator;
  settings.samples =
      has_sample_limit(render_options) ? render_settings.samples : transport::RenderSettings::Unlimited;
  settings.target_error = render_settings.target_error;
  settings.max_seconds = render_settings.max_seconds;
  settings.directions = directions;
  settings.seed = render_settings.seed;
  settings.threads = render_settings.threads;
  return BakeJob{std::move(*scene), std::move(*compiled), settings, grf::Vec3f(render_settings.view.eye)};
}

}  // namespace job
