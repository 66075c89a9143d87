#include "renderer/command/bake_command.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "grf/relocate.h"
#include "grf/text_file.h"
#include "grf/visit.h"
#include "grf/wording.h"
#include "grf/write.h"
#include "renderer/bake/baked_scene.h"
#include "renderer/bake/part_file.h"
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

/// The part of a bake that the flags choose; empty: all of it.
using Part = std::optional<bake::BakePart>;

/// Checks before a bake, as far as possible, that its result can be written.
bool can_write(const std::string& output, const Part& part, const RenderOptions& render_options,
               Diagnostics& diagnostics) {
  if (!part && !grf::is_igrf_name(output)) {
    diagnostics.error(grf::whole_file(output), "expected the name of an IGRF file, ending in '.igrf'");
    return false;
  }
  const std::string& checkpoint = render_options.checkpoint;
  return can_write_file(output, part ? "part file" : "scene", diagnostics) &&
         (checkpoint.empty() || can_write_file(checkpoint, "checkpoint", diagnostics));
}

/// Returns whether a part can be baked with these options.
bool can_bake_part(const RenderOptions& render_options, Diagnostics& diagnostics) {
  const auto refuse = [&](std::string_view key, std::string_view has) {
    diagnostics.error(render_options.locations.of(key),
                      fmt::format("a part of a bake has a number of samples and no {}", has));
    return false;
  };
  if (render_options.target_error) return refuse("BPT_TargetError", "target error");
  if (render_options.max_seconds) return refuse("BPT_MaxTime", "time limit");
  return render_options.checkpoint.empty() || refuse("BPT_Checkpoint", "checkpoint");
}

transport::Fingerprint fingerprint_of(const RenderOptions& render_options, int directions,
                                      const Diagnostics& diagnostics) {
  transport::Fingerprint fingerprint = job::fingerprint_of(render_options, diagnostics.files());
  fingerprint.options = transport::extended(fingerprint.options, fmt::format("directions {}\n", directions));
  return fingerprint;
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

/// A bake that is ready to run.
struct PreparedBake {
  PreparedBake(RenderOptions the_options, job::BakeJob the_job, transport::Fingerprint the_fingerprint)
      : render_options(std::move(the_options)),
        job(std::move(the_job)),
        points(job.scene, job.compiled, job.settings.threads),
        bake(job.compiled, points, job.settings),
        fingerprint(the_fingerprint) {}

  RenderOptions render_options;
  job::BakeJob job;
  bake::BakePoints points;
  Bake bake;
  transport::Fingerprint fingerprint;
  std::vector<bake::BakedPart> before;  ///< the parts that were baked before
};

/// Begins with what was baked before. False after an error.
bool begin_with(const bake::VertexPart& part, const std::string& path, PreparedBake& prepared,
                Diagnostics& diagnostics) {
  const auto refuse = [&](const char* why) {
    diagnostics.error(grf::whole_file(path), why);
    return false;
  };
  if (part.fingerprint != prepared.fingerprint || !bake::restore(part, prepared.bake))
    return refuse("it is no part of this bake: the scene, the options or the build of bpt differ");
  prepared.before = part.parts;
  return prepared.bake.has_pilot() || refuse("the pilot has not all vertices: merge all of its parts");
}

/// Returns nothing after an error.
std::unique_ptr<PreparedBake> prepare(const BakeArguments& arguments, const Part& part,
                                      RenderOptions render_options, Diagnostics& diagnostics) {
  if (!can_write(arguments.output, part, render_options, diagnostics)) return nullptr;
  if (part && !can_bake_part(render_options, diagnostics)) return nullptr;
  auto job = job::bake_job(render_options, arguments.directions, diagnostics);
  if (!job) return nullptr;
  job->settings.part = part;
  const transport::Fingerprint fingerprint =
      fingerprint_of(render_options, arguments.directions, diagnostics);
  auto prepared = std::make_unique<PreparedBake>(std::move(render_options), *std::move(job), fingerprint);
  if (prepared->points.count() > 0) return prepared;
  diagnostics.error(grf::whole_file(prepared->render_options.scene),
                    "the scene has no mesh to bake; lights get no irradiance");
  return nullptr;
}

/// Writes a part, with all that `bpt merge` needs to write the scene.
bool keep_part(const PreparedBake& prepared, const BakeArguments& arguments) {
  bake::VertexPart part = bake::part_of(prepared.bake, prepared.fingerprint, prepared.before);
  part.description = nlohmann::json{{"scene", std::filesystem::absolute(arguments.scene).string()},
                                    {"flags", arguments.flags},
                                    {"directions", arguments.directions}}
                         .dump();
  Diagnostics diagnostics;
  const bool kept = bake::write_part(arguments.output, part, diagnostics);
  print(diagnostics);
  return kept;
}

/// Reads what a part file says of its bake; nothing if it is not what `keep_part` writes.
std::optional<BakeArguments> arguments_of(const std::string& description) {
  const auto json = nlohmann::json::parse(description, nullptr, false);
  try {
    BakeArguments arguments;
    json.at("scene").get_to(arguments.scene);
    json.at("flags").get_to(arguments.flags);
    json.at("directions").get_to(arguments.directions);
    arguments.progress = "none";
    return arguments;
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

/// Runs a bake that was prepared, and writes it.
ExitCode finish(PreparedBake& prepared, const BakeArguments& arguments, const Part& part,
                SignalHandler& signal_handler) {
  ProgressReport progress(progress_style_of(arguments.progress));
  Diagnostics of_run;
  RunSettings settings;
  settings.checkpoint = prepared.render_options.checkpoint;
  settings.fingerprint = prepared.fingerprint;
  const bool has_run = run(prepared.bake, signal_handler, settings, progress, of_run);
  print(of_run);
  if (!has_run) return ExitCode::BadInput;
  const bool is_interrupted = signal_handler.was_signalled();
  if (part && is_interrupted) return ExitCode::Interrupted;
  const bool is_kept =
      part ? keep_part(prepared, arguments)
           : keep(prepared.bake, prepared.job, prepared.render_options.scene, arguments.output);
  if (!is_kept) return ExitCode::BadInput;
  progress.finish(prepared.bake.progress(), arguments.output);
  print_summary(prepared.bake, arguments);
  return is_interrupted ? ExitCode::Interrupted : ExitCode::Done;
}

/// Returns the totals of all parts; of samples, those that are in the sums.
transport::RenderTotals totals_of(const bake::VertexPart& sum) {
  transport::RenderTotals totals;
  for (const bake::BakedPart& part : sum.parts) {
    totals.rays += part.totals.rays;
    totals.rejected += part.totals.rejected;
    totals.first_rejected = std::min(totals.first_rejected, part.totals.first_rejected);
    totals.seconds += part.totals.seconds;
  }
  for (const bake::BakeTally& tally : sum.tallies)
    totals.paths += std::uint64_t(tally.counts[0]) + tally.counts[1];
  return totals;
}

/// Writes the scene of a bake that has all of its parts.
ExitCode write_scene(const bake::VertexPart& sum, const MergeArguments& merge) {
  const std::string& path = merge.parts.front();
  Diagnostics diagnostics;  // its files are those of the scene, of which the fingerprint is
  auto arguments = arguments_of(sum.description);
  if (!arguments) {
    diagnostics.error(grf::whole_file(path), "it does not say what bake it is of");
    print(diagnostics);
    return ExitCode::BadInput;
  }
  arguments->output = merge.outputs.front();
  arguments->json = merge.json;
  std::unique_ptr<PreparedBake> prepared;
  SignalHandler signal_handler;  // destroyed before the bake that it stops
  auto render_options = read_options(arguments->scene, diagnostics);
  if (render_options && apply_flags(arguments->flags, *render_options))
    prepared = prepare(*arguments, {}, *std::move(render_options), diagnostics);
  const bool is_ready = prepared && begin_with(sum, path, *prepared, diagnostics);
  if (is_ready) prepared->bake.restore(0, totals_of(sum));
  print(diagnostics);
  return is_ready ? finish(*prepared, *arguments, {}, signal_handler) : ExitCode::BadInput;
}

}  // namespace

ExitCode bake(const BakeArguments& given) {
  BakeArguments arguments = given;
  bool is_right = true;
  const auto image_part = image_part_of(arguments.part, arguments.flags, is_right);
  if (!is_right) return ExitCode::BadCommandLine;
  const bool has_samples = image_part && *image_part != transport::ImagePart{.index = image_part->index,
                                                                             .count = image_part->count};
  if (has_samples || image_part.has_value() != arguments.output.ends_with(".part")) {
    fmt::print(
        stderr,
        "error: a part of a bake is written to a file whose name ends in .part; --part and --pilot choose "
        "it\n");
    return ExitCode::BadCommandLine;
  }
  Part part;
  if (image_part)
    part = {static_cast<std::uint32_t>(image_part->index), static_cast<std::uint32_t>(image_part->count)};
  std::unique_ptr<PreparedBake> prepared;
  SignalHandler signal_handler;  // destroyed before the bake that it stops
  Diagnostics diagnostics;
  auto render_options = read_options(arguments.scene, diagnostics);
  if (render_options && !apply_flags(arguments.flags, *render_options)) return ExitCode::BadCommandLine;
  if (render_options) prepared = prepare(arguments, part, *std::move(render_options), diagnostics);
  const std::string& pilot = arguments.part.pilot;
  if (prepared && !pilot.empty()) {
    const auto before = bake::read_part(pilot, diagnostics);
    if (!before || !begin_with(*before, pilot, *prepared, diagnostics)) prepared.reset();
  }
  print(diagnostics);
  return prepared ? finish(*prepared, arguments, part, signal_handler) : ExitCode::BadInput;
}

ExitCode merge_bake(const MergeArguments& arguments) {
  const std::string output = arguments.outputs.empty() ? "" : arguments.outputs.front();
  if (output.empty() != arguments.lists_missing || arguments.outputs.size() > 1) {
    fmt::print(stderr, "error: give --missing, or the output of a bake: one IGRF file, or one part file\n");
    return ExitCode::BadCommandLine;
  }
  Diagnostics diagnostics;
  bake::PartMerge merge;
  bool is_done = true;
  for (const std::string& path : arguments.parts) {
    const auto part = bake::read_part(path, diagnostics);
    is_done = part && merge.add(*part, path, diagnostics) && is_done;
  }
  std::vector<transport::ImagePart> missing;
  for (const bake::BakePart& part : is_done ? merge.missing() : std::vector<bake::BakePart>())
    missing.push_back({.index = static_cast<int>(part.index), .count = static_cast<int>(part.count)});
  if (is_done && arguments.lists_missing) return print_missing(missing, arguments.json);
  if (is_done && !output.ends_with(".part") && missing.empty()) return write_scene(merge.sum(), arguments);
  if (is_done && output.ends_with(".part")) {
    is_done = bake::write_part(output, merge.sum(), diagnostics);
  } else if (is_done) {
    diagnostics.error(
        grf::whole_file(output),
        "parts of the bake lack: `bpt merge --missing` lists them; a name that ends in .part keeps "
        "those that there are");
    is_done = false;
  }
  print(diagnostics);
  return is_done ? ExitCode::Done : ExitCode::BadInput;
}

}  // namespace command
