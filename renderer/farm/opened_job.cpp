#include "renderer/farm/opened_job.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "renderer/farm/stages.h"
#include "renderer/job/job_file.h"
#include "renderer/job/render_fingerprint.h"
#include "renderer/job/target_pilot.h"
#include "renderer/options/op_file.h"

namespace farm {
namespace {

using grf::Diagnostics;
using options::RenderOptions;

/// Clears the options for files, except those that are read for the image.
void forget_outputs(RenderOptions& render_options) {
  for (const options::OptionInfo& option : options::option_table()) {
    const auto* path = std::get_if<options::PathOption>(&option.value);
    if (path != nullptr && !job::names_input(option)) (render_options.*(path->field)).clear();
  }
  render_options.display_server.clear();
}

bool can_divide(const RenderOptions& render_options, Diagnostics& diagnostics) {
  const auto refuse = [&](std::string_view key, std::string_view why) {
    diagnostics.error(render_options.locations.of(key),
                      fmt::format("a farm renders the same image as any machine: {}", why));
    return false;
  };
  if (render_options.max_seconds) {
    return refuse("BPT_MaxTime", "with a time limit, it would depend on the machines (see BPT_TargetError)");
  }
  if (render_options.frames != 1 && render_options.frame == 0)
    return refuse("BPT_Frames", "give each frame on its own (BPT_Frame)");
  return true;
}

}  // namespace

std::unique_ptr<OpenedJob> open_job(const std::string& path, Diagnostics& diagnostics) {
  auto opened = std::make_unique<OpenedJob>();
  const std::string folder = opened->folder.path().string();
  const auto op_path = job::unpack_job(path, folder, diagnostics);
  if (!op_path) return nullptr;
  Diagnostics of_scene;
  auto render_options = options::read_op_file(*op_path, of_scene);
  if (render_options) {
    forget_outputs(*render_options);
    if (can_divide(*render_options, of_scene)) opened->job = job::render_job(*render_options, of_scene);
    if (opened->job) job::truncate_paths(*render_options, *opened->job);
  }
  for (const grf::Diagnostic& entry : of_scene.entries()) {
    if (entry.severity == grf::Severity::Error) diagnostics.error(entry.location, entry.message);
    if (entry.severity == grf::Severity::Warning) diagnostics.warning(entry.location, entry.message);
  }
  if (!opened->job) return nullptr;
  if (!job::are_inside(of_scene.files(), folder)) {
    diagnostics.error(grf::whole_file(path), "the job reads files outside of its folder");
    return nullptr;
  }
  opened->job->settings.threads = 1;
  opened->fingerprint = job::fingerprint_of(*render_options, of_scene.files());
  opened->options = *std::move(render_options);
  return opened;
}

std::optional<transport::SamplePart> RunningRenders::run(const OpenedJob& job, const Task& task) {
  transport::RenderSettings settings = job.job->settings;
  settings.part = transport::ImagePart{.first_tile = task.first_tile, .end_tile = task.end_tile()};
  const auto tiles = static_cast<std::size_t>(tile_count_of(settings));
  if (!task.is_pilot) settings.part_samples = task.samples_by_tile(tiles);
  return run(job, std::move(settings));
}

std::optional<transport::SamplePart> RunningRenders::run_probe(const OpenedJob& job,
                                                               const transport::ImagePart& probe) {
  transport::RenderSettings settings = job.job->settings;
  settings.adaptive = false;
  settings.part = probe;
  return run(job, std::move(settings));
}

std::optional<transport::SamplePart> RunningRenders::run(const OpenedJob& job,
                                                         transport::RenderSettings settings) {
  settings.target_error.reset();  // the coordinator compares the whole image with it
  transport::Render render(job.job->scene, settings);
  {
    const std::lock_guard lock(lock_);
    if (is_stopped_) return std::nullopt;
    renders_.push_back(&render);
  }
  render.run();
  {
    const std::lock_guard lock(lock_);
    std::erase(renders_, &render);
  }
  if (render.is_stopped()) return std::nullopt;
  return transport::part_of(render, job.fingerprint, settings.samples);
}

void RunningRenders::stop() {
  const std::lock_guard lock(lock_);
  is_stopped_ = true;
  for (transport::Render* render : renders_) render->stop();
}

}  // namespace farm
