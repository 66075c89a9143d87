#include "renderer/command/render_command.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>
#include <unistd.h>

#include "grf/check.h"
#include "grf/read.h"
#include "renderer/command/render_fingerprint.h"
#include "renderer/command/render_reports.h"
#include "renderer/command/render_run.h"
#include "renderer/options/op_file.h"
#include "renderer/options/scheme_model.h"
#include "renderer/reflectance/scheme.h"
#include "renderer/transport/render.h"

namespace command {
namespace {

using Clock = std::chrono::steady_clock;
using grf::Diagnostics;
using grf::ExitCode;
using options::RenderOptions;
using transport::CompiledScene;

bool is_op_file(const std::string& path) { return std::filesystem::path(path).extension() == ".op"; }

/// A flag's words: `800x600` are two.
std::vector<std::string> words_of(const options::OptionInfo& option, const std::string& text) {
  const std::size_t x = text.find('x');
  if (options::word_count(option) != 2 || x == std::string::npos) return {text};
  return {text.substr(0, x), text.substr(x + 1)};
}

bool apply_flags(const RenderArguments& arguments, RenderOptions& render_options) {
  bool right = true;
  for (const options::OptionInfo& option : options::option_table()) {
    const auto given = arguments.flags.find(std::string(option.flag));
    if (option.flag.empty() || given == arguments.flags.end()) continue;
    const auto problem = set_option(render_options, option, words_of(option, given->second));
    if (problem) fmt::print(stderr, "error: {}: {}\n", option.flag, *problem);
    right = right && !problem;
    render_options.locations.erase(option.key);  // it is no longer what the file says
  }
  return right;
}

/// Where the image goes: what the command line says, else what the file says, else the scene's name.
std::vector<std::string> outputs_of(const RenderArguments& arguments, const RenderOptions& render_options) {
  if (!arguments.outputs.empty()) return arguments.outputs;
  if (!render_options.output.empty()) return {render_options.output};
  return {std::filesystem::path(render_options.scene).replace_extension(".exr").string()};
}

/// What the file says; a GRF file says which scene alone.
std::optional<RenderOptions> read_options(const std::string& path, Diagnostics& diagnostics) {
  if (is_op_file(path)) return options::read_op_file(path, diagnostics);
  RenderOptions render_options;
  render_options.scene = path;
  return render_options;
}

/// What cannot be kept is better known before the render than after it.
bool can_write_file(const std::string& output, std::string_view what, Diagnostics& diagnostics) {
  const std::filesystem::path folder = std::filesystem::path(output).parent_path();
  const std::string folder_name = folder.empty() ? "." : folder.string();
  if (::access(folder_name.c_str(), W_OK | X_OK) != 0) {
    diagnostics.error(grf::whole_file(output), fmt::format("cannot write into the folder '{}'", folder_name));
    return false;
  }
  if (!std::filesystem::is_directory(output)) return true;
  diagnostics.error(grf::whole_file(output), fmt::format("cannot write the {}: it is a directory", what));
  return false;
}

bool can_write(const std::string& output, Diagnostics& diagnostics) {
  return transport::image_format_of(output, diagnostics) != nullptr &&
         can_write_file(output, "image", diagnostics);
}

/// The scheme that the options name, checked; false after an error.
bool override_scheme(const RenderOptions& render_options, transport::CompileSettings& settings,
                     Diagnostics& diagnostics) {
  options::warn_of_unused_options(render_options, diagnostics);
  auto model = options::scheme_model(render_options);
  if (!model) return true;
  if (!grf::check(*model, reflectance::scheme_infos(), "PDF", diagnostics)) return false;
  settings.scheme = {std::move(*model), render_options.factors_file};
  return true;
}

std::optional<CompiledScene> load(const RenderOptions& render_options, Diagnostics& diagnostics) {
  const std::string& path = render_options.scene;
  transport::CompileSettings settings;
  settings.threads = render_options.threads;
  const bool has_scheme = override_scheme(render_options, settings, diagnostics);
  const auto scene = grf::read(path, diagnostics);
  if (!scene || !grf::check(*scene, reflectance::catalogue(), diagnostics) || !has_scheme) {
    return std::nullopt;
  }
  auto compiled = transport::compile(*scene, diagnostics, settings);
  if (compiled && compiled->triangle_count() == 0) {
    diagnostics.error(grf::whole_file(path), "the scene has nothing to render, expected a mesh or a light");
    return std::nullopt;
  }
  return compiled;
}

/// Reads the image around or behind the scene; false after an error.
bool load_surroundings(const RenderOptions& render_options, transport::RenderSettings& settings,
                       Diagnostics& diagnostics) {
  const std::string& path = render_options.environment;
  if (path.empty()) return true;
  const grf::SourceLocation location = render_options.locations.of("BPT_EM_Background");
  if (render_options.projection == "backplate") {
    auto image = transport::read_image(path, diagnostics, location);
    if (image) settings.backplate = std::make_shared<const transport::Image>(std::move(*image));
    return settings.backplate != nullptr;
  }
  auto map = transport::read_environment_map(path, diagnostics, location);
  if (map) settings.path.environment = std::make_shared<const transport::EnvironmentMap>(std::move(*map));
  if (render_options.resampling) {
    settings.path.resampling = {render_options.resampling->first, render_options.resampling->second};
  }
  return map.has_value();
}

transport::RenderSettings settings_of(const RenderOptions& render_options, const grf::Box3f& bounds) {
  transport::RenderSettings settings;
  settings.width = render_options.size.width;
  settings.height = render_options.size.height;
  const float aspect = static_cast<float>(settings.width) / static_cast<float>(settings.height);
  settings.view = transport::view_of(bounds, render_options.field_of_view, aspect);
  if (render_options.viewer) settings.view.eye = *render_options.viewer;
  if (render_options.target) settings.view.target = *render_options.target;
  settings.view.up = render_options.up;
  settings.path.background = render_options.background;
  settings.path.depth = render_options.depth;
  settings.path.measures_sampling = render_options.writes_sampling_time;
  settings.samples = render_options.samples;
  settings.target_error = render_options.target_error;
  settings.max_seconds = render_options.max_seconds;
  settings.seed = render_options.seed;
  settings.threads = render_options.threads;
  return settings;
}

std::size_t peak_memory_bytes() {
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

/// Tiles may differ by some samples when a render was stopped.
nlohmann::json whole_if_exact(double number) {
  const auto whole = static_cast<std::int64_t>(number);
  return static_cast<double>(whole) == number ? nlohmann::json(whole) : nlohmann::json(number);
}

nlohmann::json summary_of(const transport::Render& render, const RenderOptions& render_options,
                          const std::string& output, double setup_seconds, const CompiledScene& scene) {
  const double seconds = render.seconds();
  const auto error = render.film().estimated_error();
  nlohmann::json summary;
  summary["output"] = output;
  summary["width"] = render_options.size.width;
  summary["height"] = render_options.size.height;
  summary["samples"] = whole_if_exact(render.samples_per_pixel());
  summary["setup_seconds"] = setup_seconds;
  summary["render_seconds"] = seconds;
  summary["paths_per_second"] = static_cast<double>(render.path_count()) / seconds;
  summary["rays_per_second"] = static_cast<double>(render.ray_count()) / seconds;
  summary["estimated_error"] = error ? nlohmann::json(*error) : nlohmann::json(nullptr);
  summary["peak_memory_bytes"] = peak_memory_bytes();
  summary["effects"] = scene.effects().names();
  return summary;
}

void print(const nlohmann::json& summary, const RenderArguments& arguments) {
  const bool has_lines = arguments.progress == "json";
  if (arguments.json) fmt::print("{}\n", summary.dump(has_lines ? -1 : 2));
  if (arguments.json || has_lines) return;
  const auto number = [&](const char* name) { return summary[name].get<double>(); };
  fmt::print("{}: {}x{} pixels, {:.4g} samples a pixel\n", summary["output"].get<std::string>(),
             summary["width"].get<int>(), summary["height"].get<int>(), number("samples"));
  fmt::print("  setup {}, render {} ({:.2f} million paths and {:.2f} million rays a second)\n",
             duration_text(number("setup_seconds")), duration_text(number("render_seconds")),
             number("paths_per_second") / 1e6, number("rays_per_second") / 1e6);
  if (!summary["estimated_error"].is_null()) {
    fmt::print("  estimated error {:.2f} %\n", 100 * number("estimated_error"));
  }
  fmt::print("  peak memory {:.0f} MB, effects: {}\n", number("peak_memory_bytes") / 1e6,
             fmt::join(summary["effects"].get<std::vector<std::string>>(), ", "));
}

void print(const Diagnostics& diagnostics) { fmt::print(stderr, "{}", diagnostics.to_text()); }

/// Keeps the image and what else is to be kept, and says what went wrong.
bool keep(const transport::Render& render, const CompiledScene& scene, const RenderOptions& render_options,
          const std::vector<std::string>& outputs) {
  Diagnostics diagnostics;
  const transport::RenderTotals totals = render.totals();
  if (totals.rejected > 0) {
    const auto width = static_cast<std::uint64_t>(render_options.size.width);
    diagnostics.warning(
        {}, fmt::format("{} samples were not finite and count as black; the first pixel that "
                        "has one is ({}, {})",
                        totals.rejected, totals.first_rejected % width, totals.first_rejected / width));
  }
  const transport::Image image = render.film().mean();
  bool kept = true;
  for (const std::string& output : outputs) kept &= transport::write_image(image, output, diagnostics);
  kept &= write_reports(render, scene, render_options, outputs.front(), diagnostics);
  print(diagnostics);
  return kept;
}

/// What a render needs, once its files have been read.
struct Job {
  CompiledScene scene;
  transport::RenderSettings settings;
};

std::optional<Job> prepare(const RenderOptions& render_options, const std::vector<std::string>& outputs,
                           Diagnostics& diagnostics) {
  const bool writable = std::all_of(outputs.begin(), outputs.end(), [&](const std::string& output) {
    return can_write(output, diagnostics);
  });
  const std::string& checkpoint = render_options.checkpoint;
  if (!writable || (!checkpoint.empty() && !can_write_file(checkpoint, "checkpoint", diagnostics))) {
    return std::nullopt;
  }
  auto scene = load(render_options, diagnostics);
  transport::RenderSettings settings;
  if (scene) settings = settings_of(render_options, scene->bounds());
  if (!load_surroundings(render_options, settings, diagnostics) || !scene) return std::nullopt;
  if (settings.view.eye == settings.view.target) {
    diagnostics.error({}, "BPT_Viewer and BPT_VLook are the same point: there is no direction to look in");
    return std::nullopt;
  }
  return Job{std::move(*scene), std::move(settings)};
}

ProgressStyle style_of(const std::string& progress) {
  if (progress == "json") return ProgressStyle::Json;
  return progress == "bar" ? ProgressStyle::Bar : ProgressStyle::None;
}

/// Time and error decide how many samples there are, unless their number was given.
bool counts_samples(const RenderArguments& arguments, const RenderOptions& render_options) {
  const bool has_samples =
      arguments.flags.count("--samples") > 0 || render_options.locations.count("BPT_Samples") > 0;
  return has_samples || (!render_options.target_error && !render_options.max_seconds);
}

/// The options of files and command line together; nothing after an error that was said.
std::optional<RenderOptions> all_options(const RenderArguments& arguments, RenderOptions from_file) {
  if (!apply_flags(arguments, from_file)) return std::nullopt;
  from_file.display_server = arguments.display_server;
  if (arguments.display_server.empty() || transport::display_address_of(arguments.display_server)) {
    return from_file;
  }
  fmt::print(stderr,
             "error: --display-server: found '{}', expected a host and a port, such as localhost:14158\n",
             arguments.display_server);
  return std::nullopt;
}

RunSettings run_settings_of(const RenderOptions& render_options, const std::string& output,
                            const Diagnostics& diagnostics) {
  RunSettings settings;
  settings.checkpoint = render_options.checkpoint;
  if (!settings.checkpoint.empty()) {
    settings.fingerprint = fingerprint_of(render_options, diagnostics.files());
  }
  if (render_options.shows_window) settings.display = transport::DisplayAddress();
  if (!render_options.display_server.empty()) {
    settings.display = transport::display_address_of(render_options.display_server);
  }
  settings.title = output;
  return settings;
}

}  // namespace

grf::ExitCode render(const RenderArguments& arguments) {
  const auto start = Clock::now();
  std::optional<Job> job;
  std::optional<transport::Render> render;
  Interruption interruption;  // ends before the render that it stops
  Diagnostics diagnostics;
  auto render_options = read_options(arguments.scene, diagnostics);
  std::vector<std::string> outputs;
  if (render_options) {
    render_options = all_options(arguments, std::move(*render_options));
    if (!render_options) return ExitCode::BadCommandLine;
    outputs = outputs_of(arguments, *render_options);
    job = prepare(*render_options, outputs, diagnostics);
  }
  print(diagnostics);
  if (!job) return ExitCode::BadInput;
  if (!counts_samples(arguments, *render_options)) {
    job->settings.samples = transport::RenderSettings::Unlimited;
  }
  const RunSettings settings = run_settings_of(*render_options, outputs.front(), diagnostics);
  render.emplace(job->scene, job->settings);
  const double setup_seconds = std::chrono::duration<double>(Clock::now() - start).count();
  ProgressReport progress(style_of(arguments.progress));
  Diagnostics of_run;
  const bool has_run = run(*render, interruption, settings, progress, of_run);
  print(of_run);
  if (!has_run || !keep(*render, job->scene, *render_options, outputs)) return ExitCode::BadInput;
  progress.finish(render->progress(), outputs.front());
  print(summary_of(*render, *render_options, outputs.front(), setup_seconds, job->scene), arguments);
  return interruption.has_come() ? ExitCode::Interrupted : ExitCode::Done;
}

}  // namespace command
