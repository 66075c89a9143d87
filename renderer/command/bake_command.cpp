#include "renderer/command/bake_command.h"

#include <cstdio>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "grf/relocate.h"
#include "grf/text_file.h"
#include "grf/visit.h"
#include "grf/wording.h"
#include "grf/write.h"
#include "renderer/bake/baked_scene.h"
#include "renderer/command/json_values.h"
#include "renderer/command/printed.h"
#include "renderer/command/render_output.h"
#include "renderer/command/render_run.h"
#include "renderer/job/render_fingerprint.h"
#include "renderer/job/render_job.h"

namespace command {
namespace {

using bake::Bake;
using grf::counted;
using grf::Diagnostics;
using grf::ExitCode;
using options::RenderOptions;

/// Checks before a bake, as far as possible, that its result can be written.
bool can_write(const std::string& output, const RenderOptions& render_options, Diagnostics& diagnostics) {
  if (!grf::is_igrf_name(output)) {
    diagnostics.error(grf::whole_file(output), "expected the name of an IGRF file, ending in '.igrf'");
    return false;
  }
  const std::string& checkpoint = render_options.checkpoint;
  return can_write_file(output, "scene", diagnostics) &&
         (checkpoint.empty() || can_write_file(checkpoint, "checkpoint", diagnostics));
}

RunSettings run_settings_of(const RenderOptions& render_options, int directions,
                            const Diagnostics& diagnostics) {
  RunSettings settings;
  settings.checkpoint = render_options.checkpoint;
  if (settings.checkpoint.empty()) return settings;
  settings.fingerprint = job::fingerprint_of(render_options, diagnostics.files());
  settings.fingerprint.options =
      transport::extended(settings.fingerprint.options, fmt::format("directions {}\n", directions));
  return settings;
}

void warn(const Bake& bake, const bake::BakedScene& baked, const std::string& scene,
          Diagnostics& diagnostics) {
  const grf::SourceLocation file = grf::whole_file(scene);
  if (baked.copies > 0) {
    diagnostics.warning(file,
                        fmt::format("{} placed by 'use' more than once; the irradiance of each instance "
                                    "differs, so {} written",
                                    counted(baked.shared_meshes, "mesh is", "meshes are"),
                                    counted(baked.copies, "copy is", "copies are")));
  }
  if (const std::size_t without = bake.vertex_count() - bake.value_count(); without > 0) {
    diagnostics.warning(
        file,
        counted(
            without, "vertex has no irradiance: it has no face with area, or the bake was stopped before it",
            "vertices have no irradiance: they have no face with area, or the bake was stopped before them"));
  }
  if (const std::uint64_t rejected = bake.totals().rejected; rejected > 0) {
    diagnostics.warning(
        file, fmt::format("{} at vertex {}", rejected_samples_text(rejected), bake.totals().first_rejected));
  }
}

/// Writes the baked scene. An IGRF file names its observer, though irradiance does not depend on one.
bool keep(const Bake& bake, job::BakeJob& job, const std::string& scene, const std::string& output) {
  Diagnostics diagnostics;
  bake::BakedScene baked = bake::with_irradiance(std::move(job.scene), bake);
  if (grf::observers_of(baked.scene).empty()) {
    baked.scene.contents.blocks.push_back({grf::Params{{job.eye}}, {}, {}});
  }
  grf::relocate(baked.scene, scene, output);
  warn(bake, baked, scene, diagnostics);
  const bool kept = grf::write(baked.scene, output, diagnostics);
  print(diagnostics);
  return kept;
}

void print_summary(const Bake& bake, const BakeArguments& arguments) {
  const auto error = bake.estimated_error();
  nlohmann::json summary;
  summary["output"] = arguments.output;
  summary["vertices"] = bake.value_count();
  summary["samples"] = bake.samples_per_vertex();
  summary["render_seconds"] = bake.totals().seconds;
  summary["estimated_error"] = error ? nlohmann::json(*error) : nlohmann::json(nullptr);
  const bool has_lines = arguments.progress == "json";
  if (arguments.json) fmt::print("{}\n", json_text(summary, has_lines));
  if (arguments.json || has_lines) return;
  fmt::print("{}: irradiance at {}, {} per vertex, in {}\n", arguments.output,
             counted(bake.value_count(), "vertex", "vertices"), samples_text(bake.samples_per_vertex()),
             duration_text(bake.totals().seconds));
  if (error) fmt::print("  estimated error {:.2f} %\n", 100 * *error);
}

}  // namespace

ExitCode bake(const BakeArguments& arguments) {
  std::optional<job::BakeJob> job;
  std::optional<bake::BakePoints> points;
  std::optional<Bake> bake;
  SignalHandler signal_handler;  // destroyed before the bake that it stops
  Diagnostics diagnostics;
  auto render_options = read_options(arguments.scene, diagnostics);
  if (render_options) {
    if (!apply_flags(arguments.flags, *render_options)) return ExitCode::BadCommandLine;
    if (can_write(arguments.output, *render_options, diagnostics)) {
      job = job::bake_job(*render_options, arguments.directions, diagnostics);
    }
  }
  if (job) points.emplace(job->scene, job->compiled, job->settings.threads);
  if (points && points->count() == 0) {
    diagnostics.error(grf::whole_file(render_options->scene),
                      "the scene has no mesh to bake; lights get no irradiance");
  }
  print(diagnostics);
  if (!job || points->count() == 0) return ExitCode::BadInput;
  bake.emplace(job->compiled, *points, job->settings);
  ProgressReport progress(progress_style_of(arguments.progress));
  Diagnostics of_run;
  const RunSettings settings = run_settings_of(*render_options, arguments.directions, diagnostics);
  const bool has_run = run(*bake, signal_handler, settings, progress, of_run);
  print(of_run);
  if (!has_run || !keep(*bake, *job, render_options->scene, arguments.output)) return ExitCode::BadInput;
  progress.finish(bake->progress(), arguments.output);
  print_summary(*bake, arguments);
  return signal_handler.was_signalled() ? ExitCode::Interrupted : ExitCode::Done;
}

}  // namespace command
