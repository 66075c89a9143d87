#include <chrono>
#include <cstdio>
#include <filesystem>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "grf/short_lived_folder.h"
#include "grf/text_file.h"
#include "renderer/command/farm_command.h"
#include "renderer/command/json_values.h"
#include "renderer/command/merge_command.h"
#include "renderer/command/pack_command.h"
#include "renderer/command/printed.h"
#include "renderer/command/render_output.h"
#include "renderer/command/render_progress.h"
#include "renderer/command/signal_handler.h"
#include "renderer/farm/coordinator.h"

namespace command {
namespace {

using grf::Diagnostics;
using grf::ExitCode;

/// Shows the progress of a job like `ProgressReport`, with parts and workers.
class FarmProgress {
 public:
  explicit FarmProgress(ProgressStyle style) : style_(style) {
    if (style == ProgressStyle::Bar && ::isatty(STDERR_FILENO) == 0) style_ = ProgressStyle::None;
  }

  void show(const farm::Progress& progress) {
    if (style_ == ProgressStyle::None || Clock::now() < next_) return;
    next_ = Clock::now() + std::chrono::milliseconds(250);
    if (style_ == ProgressStyle::Json) return print_json(progress, nullptr);
    std::string line = fmt::format("{} of {} parts, {} {}", progress.parts_done, progress.parts,
                                   progress.workers, progress.workers == 1 ? "worker" : "workers");
    if (progress.workers == 0) line += " (`bpt farm work` starts one)";
    if (progress.error) line += fmt::format(", error {:.2f} %", 100 * *progress.error);
    if (progress.seconds_left) line += fmt::format(", {} left", duration_text(*progress.seconds_left));
    fmt::print(stderr, "\r{}\x1b[K", line);
    std::fflush(stderr);
  }

  /// Ends the progress, with the path of the image if it was written.
  void finish(const farm::Progress& progress, const nlohmann::json& image) {
    if (style_ == ProgressStyle::Json) print_json(progress, image);
    if (style_ == ProgressStyle::Bar) fmt::print(stderr, "\r\x1b[K");
    style_ = ProgressStyle::None;
  }

 private:
  using Clock = std::chrono::steady_clock;

  static void print_json(const farm::Progress& progress, const nlohmann::json& image) {
    nlohmann::ordered_json line = nlohmann::ordered_json::parse(farm::json_of(progress));
    line.erase("time");
    line["image"] = image;
    std::fputs((json_text(line, true) + "\n").c_str(), stdout);
    std::fflush(stdout);
  }

  ProgressStyle style_;
  Clock::time_point next_ = Clock::now();
};

/// A job that is to be rendered, and the options that the user gave for it.
struct Submission {
  std::string job_file;  ///< its bytes
  std::unique_ptr<farm::OpenedJob> opened;
  options::RenderOptions options;
};

/// Packs the scene, and opens the job file as workers do.
ExitCode prepare(const FarmRenderArguments& arguments, Submission& submission, Diagnostics& diagnostics) {
  const grf::ShortLivedFolder folder("grffarm");
  const std::string path = (folder.path() / "job.grfjob").string();
  UnpackedJob unpacked;
  std::optional<std::string> scene = arguments.scene;
  if (is_job_file(arguments.scene)) scene = unpacked.unpack(arguments.scene, diagnostics);
  auto render_options = scene ? read_options(*scene, diagnostics) : std::nullopt;
  if (!render_options) return ExitCode::BadInput;
  if (!apply_flags(arguments.flags, *render_options)) return ExitCode::BadCommandLine;
  if (!can_write(arguments.outputs, *render_options, diagnostics)) return ExitCode::BadInput;
  const ExitCode code = pack_scene(*scene, arguments.flags, path, diagnostics);
  if (code != ExitCode::Done) return code;
  Diagnostics of_packed;  // the warnings were there when it was packed
  submission.opened = farm::open_job(path, of_packed);
  if (!submission.opened) {
    for (const auto& entry : of_packed.entries()) diagnostics.error(entry.location, entry.message);
    return ExitCode::BadInput;
  }
  const auto bytes = grf::read_file(path, diagnostics);
  if (!bytes) return ExitCode::BadInput;
  submission.job_file = *bytes;
  submission.options = *std::move(render_options);
  return ExitCode::Done;
}

bool write_images(const farm::Coordinator& coordinator, const Submission& submission,
                  const FarmRenderArguments& arguments, Diagnostics& diagnostics) {
  const job::RenderJob& job = *submission.opened->job;
  const transport::Render render(job.scene, job.settings);
  const ImageDescription description = description_of(render, job.scene, submission.options);
  const bool has_lines = progress_style_of(arguments.progress) == ProgressStyle::Json;
  const SummaryStyle style = !arguments.access.json ? SummaryStyle::Text
                             : has_lines            ? SummaryStyle::JsonLine
                                                    : SummaryStyle::Json;
  return write_merged(coordinator.merge(), job.settings.bias, description, arguments.outputs, style,
                      diagnostics);
}

}  // namespace

ExitCode farm_render(const FarmRenderArguments& arguments) {
  std::optional<farm::Coordinator> coordinator;
  SignalHandler signal_handler;  // destroyed before the coordinator that it stops
  const auto farm = join_farm(arguments.access, "render");
  if (!farm) return ExitCode::BadInput;
  Diagnostics diagnostics;
  Submission submission;
  const ExitCode code = prepare(arguments, submission, diagnostics);
  print(diagnostics);
  if (code != ExitCode::Done) return code;
  farm::CoordinatorSettings settings;
  settings.name = std::filesystem::path(arguments.scene).filename().string();
  settings.version = GRANADA_VERSION;
  settings.ledger = arguments.outputs.front() + ".ledger";
  settings.part_seconds = arguments.part_seconds;
  settings.lease_seconds = arguments.lease_seconds;
  coordinator.emplace(*farm, *submission.opened, settings);
  signal_handler.stop_on_signal(*coordinator);
  FarmProgress progress(progress_style_of(arguments.progress));
  farm::Progress last;
  const auto show = [&](const farm::Progress& now) {
    last = now;
    for (const std::string& warning : coordinator->take_warnings())
      fmt::print(stderr, "warning: {}\n", warning);
    progress.show(now);
  };
  Diagnostics of_run;
  bool is_done = coordinator->submit(submission.job_file, of_run) && coordinator->run(show, of_run);
  if (is_done && coordinator->is_complete()) {
    is_done = write_images(*coordinator, submission, arguments, of_run);
    if (is_done) coordinator->finish();
    progress.finish(last, is_done ? nlohmann::json(arguments.outputs.front()) : nlohmann::json(nullptr));
    print(of_run);
    return is_done ? ExitCode::Done : ExitCode::BadInput;
  }
  progress.finish(last, nullptr);
  print(of_run);
  if (!signal_handler.was_signalled()) return ExitCode::BadInput;
  fmt::print(stderr,
             "interrupted: workers continue, and the same command resumes the work (`bpt farm stop {}` "
             "ends it)\n",
             coordinator->info().id);
  return ExitCode::Interrupted;
}

}  // namespace command
