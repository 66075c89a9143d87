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

#include "renderer/command/image_viewer_process.h"
#include "renderer/command/json_values.h"
#include "renderer/command/pack_command.h"
#include "renderer/command/plan_summary.h"
#include "renderer/command/printed.h"
#include "renderer/command/render_arguments.h"
#include "renderer/command/render_forecast.h"
#include "renderer/command/render_output.h"
#include "renderer/command/render_reports.h"
#include "renderer/command/render_run.h"
#include "renderer/job/camera_path.h"
#include "renderer/job/non_finite.h"
#include "renderer/job/render_fingerprint.h"
#include "renderer/job/render_job.h"
#include "renderer/job/target_pilot.h"
#include "renderer/parallel/loops.h"
#include "renderer/transport/part_merge.h"
#include "renderer/transport/render.h"
#include "renderer/transport/visible_noise.h"

namespace command {
namespace {

using Clock = std::chrono::steady_clock;
using grf::Diagnostics;
using grf::ExitCode;
using options::RenderOptions;
using transport::CompiledScene;

/// Returns the output images: those of the command line, else that of the OP file, else the scene's name.
std::vector<std::string> outputs_of(const RenderArguments& arguments, const RenderOptions& render_options) {
  if (!arguments.outputs.empty()) return arguments.outputs;
  if (!render_options.output.empty()) return {render_options.output};
  const std::string& scene = is_job_file(arguments.scene) ? arguments.scene : render_options.scene;
  return {std::filesystem::path(scene).replace_extension(".exr").string()};
}

std::size_t peak_memory_bytes() {
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

/// Returns an integer if the mean is whole: tiles of a stopped render may differ by some samples.
nlohmann::json whole_if_exact(double number) {
  const auto whole = static_cast<std::int64_t>(number);
  return static_cast<double>(whole) == number ? nlohmann::json(whole) : nlohmann::json(number);
}

nlohmann::json summary_of(const transport::Render& render,
                          const std::optional<transport::ErrorEstimate>& estimate,
                          const RenderOptions& render_options, const std::string& output,
                          double setup_seconds, const plan::Plan& plan) {
  const double seconds = render.seconds();
  nlohmann::json summary;
  summary["output"] = output;
  summary["width"] = render_options.size.width;
  summary["height"] = render_options.size.height;
  summary["samples"] = whole_if_exact(render.samples_per_pixel());
  summary["setup_seconds"] = setup_seconds;
  summary["render_seconds"] = seconds;
  summary["paths_per_second"] = static_cast<double>(render.path_count()) / seconds;
  summary["rays_per_second"] = static_cast<double>(render.ray_count()) / seconds;
  add_estimate(estimate, summary);
  add_bias(render.settings().bias, summary);
  summary["peak_memory_bytes"] = peak_memory_bytes();
  add_plan(plan, summary);
  return summary;
}

/// The visible difference from the converged image, and the samples with which it is no longer seen; null if
/// it is not known.
nlohmann::json visible_difference_of(const transport::Render& render, const RenderOptions& render_options) {
  image::Viewing viewing;
  viewing.exposure = double(render_options.exposure);
  const auto noise = transport::visible_noise(render, viewing);
  if (!noise) return nullptr;
  auto json = json_of(noise->difference, viewing);
  json["samples_needed"] = noise->samples_needed;
  return json;
}

void print_summary(const nlohmann::json& summary, const RenderArguments& arguments) {
  const bool has_lines = arguments.progress == "json";
  if (arguments.json) fmt::print("{}\n", json_text(summary, has_lines));
  if (arguments.json || has_lines) return;
  const auto number = [&](const char* name) { return summary[name].get<double>(); };
  fmt::print("{}: {}x{} pixels, {} per pixel\n", summary["output"].get<std::string>(),
             summary["width"].get<int>(), summary["height"].get<int>(), samples_text(number("samples")));
  fmt::print("  setup {}, render {} ({:.2f} million paths and {:.2f} million rays per second)\n",
             duration_text(number("setup_seconds")), duration_text(number("render_seconds")),
             number("paths_per_second") / 1e6, number("rays_per_second") / 1e6);
  print_estimate(summary);
  fmt::print("  peak memory {:.0f} MB, effects: {}\n", number("peak_memory_bytes") / 1e6,
             fmt::join(summary["effects"].get<std::vector<std::string>>(), ", "));
  fmt::print("  {}\n", left_out_line(summary));
}

/// Warns of samples that could not be added.
void report_rejected(const transport::Render& render, const CompiledScene& scene, Diagnostics& diagnostics) {
  const transport::RenderTotals totals = render.totals();
  if (totals.rejected == 0) return;
  const auto width = static_cast<std::uint64_t>(render.film().width());
  diagnostics.warning(
      {}, fmt::format("{} in pixel ({}, {}): {}", rejected_samples_text(totals.rejected),
                      totals.first_rejected % width, totals.first_rejected / width,
                      job::cause_text(render.cause_of_rejection().value_or(transport::NotFinite()), scene)));
}

/// Writes the image and the reports, and prints errors.
bool keep(const transport::Render& render, const std::optional<transport::ErrorEstimate>& estimate,
          const CompiledScene& scene, const RenderOptions& render_options,
          const std::vector<std::string>& outputs) {
  Diagnostics diagnostics;
  report_rejected(render, scene, diagnostics);
  image::ImageFile file;
  parallel::run_with_threads(render.settings().threads, [&] {
    file = image_file_of(render.film(), description_of(render, scene, render_options), render.seconds(),
                         estimate);
  });
  const std::vector<std::string> fallbacks = image::fallback_folders();
  bool kept = true;
  for (const std::string& output : outputs) {
    kept &= image::keep_image(file, output, fallbacks, diagnostics);
  }
  kept &= write_reports(render, scene, render_options, outputs.front(), diagnostics);
  print(diagnostics);
  return kept;
}

/// A part of the samples of an image that is to be rendered.
struct PartTask {
  transport::ImagePart part;
  std::string pilot;  ///< path; empty: none
};

/// Returns whether a part can be rendered with these options.
bool can_render_part(const PartTask& task, const RenderOptions& render_options, Diagnostics& diagnostics) {
  const auto refuse = [&](std::string_view key, const std::string& why) {
    diagnostics.error(render_options.locations.of(key), why);
    return false;
  };
  if (render_options.target_error) {
    return refuse("BPT_TargetError", "a part of an image has a number of samples and no target error");
  }
  if (render_options.max_seconds) {
    return refuse("BPT_MaxTime", "a part of an image has a number of samples and no time limit");
  }
  const bool has_ranges =
      task.part != transport::ImagePart{.index = task.part.index, .count = task.part.count};
  if (render_options.adaptive && has_ranges) {
    return refuse("BPT_Adaptive", "of an adaptive image, parts are chosen by --part alone");
  }
  if (!render_options.adaptive && !task.pilot.empty()) {
    diagnostics.error(grf::whole_file(task.pilot), "only parts of an adaptive image have a pilot");
    return false;
  }
  return true;
}

/// Reads the pilot of an adaptive image, and takes the samples of its part that follow.
bool place_by_pilot(const PartTask& task, const transport::Fingerprint& fingerprint,
                    transport::RenderSettings& settings, Diagnostics& diagnostics) {
  const std::string& path = task.pilot;
  auto part = transport::read_part(path, diagnostics);
  if (!part) return false;
  const bool fits = part->fingerprint == fingerprint && part->is_adaptive != 0;
  transport::PartMerge merge;
  merge.add(std::move(*part), path, diagnostics);
  if (fits && merge.has_whole_pilot()) {
    const auto counts = transport::AdaptiveSampling(merge.film()).counts(settings.samples);
    const auto pilot = transport::uniform_counts(transport::AdaptiveSampling::PilotSamples);
    settings.part_samples = transport::samples_of(task.part, counts, pilot);
    return true;
  }
  diagnostics.error(grf::whole_file(path), fits ? "the pilot has not all tiles: merge all of its parts"
                                                : "it is no pilot of this image");
  return false;
}

std::optional<job::RenderJob> prepare(const RenderOptions& render_options,
                                      const std::vector<std::string>& outputs,
                                      const std::optional<PartTask>& task, Diagnostics& diagnostics) {
  const std::string& checkpoint = render_options.checkpoint;
  if (task ? !can_render_part(*task, render_options, diagnostics) ||
                 !can_write_file(outputs.front(), "part file", diagnostics)
           : !can_write(outputs, render_options, diagnostics)) {
    return std::nullopt;
  }
  if (!checkpoint.empty() && !can_write_file(checkpoint, "checkpoint", diagnostics)) return std::nullopt;
  auto job = job::render_job(render_options, diagnostics);
  if (job && task) job->settings.part = task->part;
  if (job) job::truncate_paths(render_options, *job);
  return job;
}

RunSettings run_settings_of(const RenderOptions& render_options, const std::string& output,
                            const std::optional<PartTask>& task, const Diagnostics& diagnostics) {
  RunSettings settings;
  settings.checkpoint = render_options.checkpoint;
  if (!settings.checkpoint.empty() || task) {
    settings.image_fingerprint = job::fingerprint_of(render_options, diagnostics.files());
    settings.fingerprint = settings.image_fingerprint;
  }
  // The checkpoint of a part is of no use to another part.
  if (task) {
    settings.fingerprint.options =
        transport::extended(settings.fingerprint.options, flags_text(task->part) + task->pilot);
  }
  if (!render_options.display_server.empty()) {
    settings.display = display::address_of(render_options.display_server);
  } else if (render_options.shows_window) {
    settings.display = display::default_address();
    settings.viewer_launcher = [viewer = ImageViewerProcess()]() mutable { return viewer.ensure_running(); };
  }
  settings.title = output;
  return settings;
}

/// Writes a part that was rendered, prints a summary, and returns whether that succeeded.
bool keep_part(const transport::Render& render, const transport::Fingerprint& fingerprint,
               const job::RenderJob& job, const RenderOptions& render_options, const std::string& output,
               const RenderArguments& arguments) {
  Diagnostics diagnostics;
  report_rejected(render, job.scene, diagnostics);
  transport::SamplePart part = transport::part_of(render, fingerprint, job.settings.samples);
  if (part.tiles.front().has_first_sample()) {
    part.description = bytes_of(description_of(render, job.scene, render_options));
  }
  const bool is_kept = transport::write_part(output, part, diagnostics);
  print(diagnostics);
  const nlohmann::json summary = {{"output", output},
                                  {"paths", render.path_count()},
                                  {"image_samples", job.settings.samples},
                                  {"render_seconds", render.seconds()}};
  const bool has_lines = arguments.progress == "json";
  if (arguments.json) fmt::print("{}\n", json_text(summary, has_lines));
  if (!arguments.json && !has_lines) {
    fmt::print("{}: {} of {} samples per pixel of {}x{} pixels, in {}\n", output,
               whole_if_exact(static_cast<double>(render.path_count()) / part.width / part.height).dump(),
               job.settings.samples, part.width, part.height, duration_text(render.seconds()));
  }
  return is_kept;
}

/// Renders and writes one image; `before` has the messages about the options.
ExitCode render_image(const RenderArguments& arguments, const RenderOptions& render_options,
                      const std::vector<std::string>& outputs, const std::optional<PartTask>& task,
                      const Diagnostics& before) {
  const auto start = Clock::now();
  std::optional<transport::Render> render;
  SignalHandler signal_handler;  // destroyed before the render that it stops
  Diagnostics diagnostics = before;
  std::optional<job::RenderJob> job = prepare(render_options, outputs, task, diagnostics);
  print(diagnostics);
  if (!job) return ExitCode::BadInput;
  const RunSettings settings = run_settings_of(render_options, outputs.front(), task, diagnostics);
  if (task && !task->pilot.empty()) {
    Diagnostics of_pilot;
    const bool is_placed = place_by_pilot(*task, settings.image_fingerprint, job->settings, of_pilot);
    print(of_pilot);
    if (!is_placed) return ExitCode::BadInput;
  }
  render.emplace(job->scene, job->settings);
  const double setup_seconds = std::chrono::duration<double>(Clock::now() - start).count();
  ProgressReport progress(progress_style_of(arguments.progress));
  Diagnostics of_run;
  const bool has_run = run(*render, signal_handler, settings, progress, of_run);
  print(of_run);
  if (!has_run) return ExitCode::BadInput;
  if (task) {
    if (signal_handler.was_signalled()) return ExitCode::Interrupted;
    const bool is_kept =
        keep_part(*render, settings.image_fingerprint, *job, render_options, outputs.front(), arguments);
    if (is_kept) progress.finish(render->progress(), outputs.front());
    return is_kept ? ExitCode::Done : ExitCode::BadInput;
  }
  const auto estimate = render->error_estimate();
  if (!keep(*render, estimate, job->scene, render_options, outputs)) {
    return ExitCode::BadInput;
  }
  progress.finish(render->progress(), outputs.front());
  nlohmann::json summary =
      summary_of(*render, estimate, render_options, outputs.front(), setup_seconds, job->plan);
  if (arguments.json) summary["visible_difference"] = visible_difference_of(*render, render_options);
  print_summary(summary, arguments);
  return signal_handler.was_signalled() ? ExitCode::Interrupted : ExitCode::Done;
}

/// Renders the frames of an animation, up to the first that fails.
ExitCode render_frames(const RenderArguments& arguments, RenderOptions render_options,
                       const std::vector<std::string>& outputs, const std::optional<PartTask>& task,
                       const Diagnostics& diagnostics) {
  const std::string checkpoint = render_options.checkpoint;
  for (const int frame : job::frames_of(render_options)) {
    render_options.frame = frame;
    if (!checkpoint.empty()) render_options.checkpoint = job::file_of_frame(checkpoint, frame);
    std::vector<std::string> of_frame;
    for (const std::string& output : outputs) of_frame.push_back(job::file_of_frame(output, frame));
    const ExitCode code = render_image(arguments, render_options, of_frame, task, diagnostics);
    if (code != ExitCode::Done) return code;
  }
  return ExitCode::Done;
}

}  // namespace

grf::ExitCode render(const RenderArguments& arguments) {
  Diagnostics diagnostics;
  UnpackedJob unpacked;
  std::optional<std::string> scene = arguments.scene;
  if (is_job_file(arguments.scene)) scene = unpacked.unpack(arguments.scene, diagnostics);
  auto render_options = scene ? read_options(*scene, diagnostics) : std::nullopt;
  if (!render_options) {
    print(diagnostics);
    return ExitCode::BadInput;
  }
  OptionFlags flags = arguments.flags;
  bool is_right = true;
  const auto part = image_part_of(arguments.part, flags, is_right);
  if (!apply_flags(flags, *render_options) || !is_right) return ExitCode::BadCommandLine;
  if (arguments.forecasts) return forecast(arguments, *render_options, diagnostics);
  const std::vector<std::string> outputs = outputs_of(arguments, *render_options);
  const bool writes_part = outputs.front().ends_with(".part");
  if (part.has_value() != writes_part || (part && outputs.size() > 1)) {
    fmt::print(stderr,
               "error: a part of the samples is written to one file, whose name ends in .part; --part, "
               "--samples with a range, --tiles or --pilot choose it\n");
    return ExitCode::BadCommandLine;
  }
  const auto task = part ? std::optional(PartTask{*part, arguments.part.pilot}) : std::nullopt;
  if (render_options->frames == 1)
    return render_image(arguments, *render_options, outputs, task, diagnostics);
  return render_frames(arguments, *render_options, outputs, task, diagnostics);
}

}  // namespace command
