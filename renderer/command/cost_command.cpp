#include "renderer/command/cost_command.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "grf/write.h"
#include "renderer/command/cost_report.h"
#include "renderer/command/cost_sweep.h"
#include "renderer/command/render_output.h"
#include "renderer/command/render_run.h"
#include "renderer/job/render_job.h"

namespace command {
namespace {

using grf::Diagnostics;
using grf::ExitCode;
using options::RenderOptions;
using transport::CompiledScene;
using transport::PixelSampling;

bool is_naive(const CostLine& line) { return line.options.integrator == "naive"; }

/// Makes the subjects of lines; lines that need the same tables share a compiled scene.
class Subjects {
 public:
  Subjects(const grf::Scene& scene, bool has_centred_rays, Diagnostics& diagnostics)
      : scene_(scene), has_centred_rays_(has_centred_rays), diagnostics_(diagnostics) {}

  /// Returns nothing after an error.
  std::optional<CostSubject> of(const CostLine& line) {
    auto compile_settings = job::compile_settings_of(line.options, diagnostics_);
    if (!compile_settings) return std::nullopt;
    if (line.scheme) compile_settings->scheme = {*line.scheme, line.options.factors_file};
    auto planned = job::render_plan(scene_, std::move(*compile_settings), line.options, diagnostics_);
    if (!planned) return std::nullopt;
    auto compiled = compile(line, planned->compile_settings);
    planned->settings.integrator.environment = environment_;
    planned->settings.backplate = backplate_;
    if (!job::load_environment(line.options, *planned, diagnostics_) || !compiled) return std::nullopt;
    if (planned->settings.integrator.environment) environment_ = planned->settings.integrator.environment;
    if (planned->settings.backplate) backplate_ = planned->settings.backplate;
    if (has_centred_rays_) planned->settings.pixel_sampling = PixelSampling::Centre;
    return CostSubject{std::move(compiled), std::move(planned->settings)};
  }

 private:
  std::shared_ptr<const CompiledScene> compile(const CostLine& line,
                                               const transport::CompileSettings& settings) {
    const std::string key = fmt::format("{} {} {} {}", line.scheme ? to_text(*line.scheme) : "",
                                        line.options.integrator, line.options.precision, line.options.depth);
    const auto known = compiled_.find(key);
    if (known != compiled_.end()) return known->second;
    auto scene = transport::compile(scene_, diagnostics_, settings);
    if (!scene || !job::has_geometry(*scene, line.options, diagnostics_)) return nullptr;
    return compiled_.emplace(key, std::make_shared<const CompiledScene>(std::move(*scene))).first->second;
  }

  const grf::Scene& scene_;
  bool has_centred_rays_;
  Diagnostics& diagnostics_;
  std::map<std::string, std::shared_ptr<const CompiledScene>> compiled_;
  // Shared by all lines, so read once.
  std::shared_ptr<const transport::EnvironmentMap> environment_;
  std::shared_ptr<const transport::Image> backplate_;
};

/// Returns the reference's line: `path`, the best scheme of each BRDF, Sobol points and the greatest depth.
CostLine reference_line(const std::vector<CostLine>& lines, const RenderOptions& of_scene) {
  CostLine line;
  line.name = "reference";
  line.options = of_scene;
  static_cast<options::SchemeOptions&>(line.options) = {};
  line.options.integrator = "path";
  line.options.points = "sobol";
  line.options.precision = "float";
  for (const CostLine& one : lines) line.options.depth = std::max(line.options.depth, one.options.depth);
  line.scheme = grf::PdfModel();
  line.scheme->keyword = "auto";
  return line;
}

/// Clears the options that limit a single render: the sweep sets the sample counts.
RenderOptions for_sweep(RenderOptions render_options) {
  render_options.samples.reset();
  render_options.target_error.reset();
  render_options.max_seconds.reset();
  render_options.ray_casting = false;
  render_options.writes_sampling_time = false;
  return render_options;
}

bool prepare_lines(const std::vector<CostLine>& lines, const RenderOptions& render_options, CostPlan& plan,
                   Diagnostics& diagnostics) {
  const auto scene = job::read_scene(render_options, diagnostics);
  if (!scene) return false;
  Subjects subjects(*scene, std::any_of(lines.begin(), lines.end(), is_naive), diagnostics);
  // The first compilation takes longer, because threads start: no line is to be charged for that.
  auto reference = subjects.of(reference_line(lines, render_options));
  if (!reference) return false;
  plan.reference = std::move(*reference);
  for (const CostLine& line : lines) {
    auto subject = subjects.of(line);
    if (!subject) return false;
    plan.lines.push_back(std::move(*subject));
  }
  return true;
}

bool read_reference(const std::string& path, const options::ImageSize& size, CostPlan& plan,
                    Diagnostics& diagnostics) {
  if (path.empty()) return true;
  plan.given = transport::read_image(path, diagnostics);
  if (!plan.given) return false;
  if (plan.given->width == size.width && plan.given->height == size.height) return true;
  diagnostics.error(grf::whole_file(path),
                    fmt::format("the reference has {} x {} pixels, expected {} x {}, the size of the renders",
                                plan.given->width, plan.given->height, size.width, size.height));
  return false;
}

/// Checks that sample counts of `naive` are multiples of its camera rays per pixel.
bool can_divide(const std::vector<CostLine>& lines, const std::vector<int>& samples) {
  for (const CostLine& line : lines) {
    const int rays = line.options.pixel_samples.first * line.options.pixel_samples.second;
    for (const int count : samples) {
      if (!is_naive(line) || count % rays == 0) continue;
      fmt::print(stderr,
                 "error: --samples: found {}, expected multiples of {} for naive, its camera rays per pixel "
                 "(BPT_Pixel_SampleRes)\n",
                 count, rays);
      return false;
    }
  }
  return true;
}

std::string base_of(const CostArguments& arguments, const RenderOptions& render_options) {
  if (!arguments.output.empty()) return arguments.output;
  return std::filesystem::path(render_options.scene).replace_extension().string() + "-cost";
}

bool can_write(const std::string& base, Diagnostics& diagnostics) {
  return can_write_file(base + ".csv", "table", diagnostics) &&
         can_write_file(base + ".md", "report", diagnostics) &&
         can_write_file(base + ".svg", "picture", diagnostics);
}

std::size_t bytes_of(const CompiledScene& scene) {
  std::size_t bytes = 0;
  for (const transport::TableInfo& table : scene.tables()) bytes += table.bytes;
  return bytes;
}

std::vector<CostLineResult> results_of(const CostSweep& sweep, const CostPlan& plan,
                                       const std::vector<CostLine>& lines) {
  std::vector<CostLineResult> results;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const CompiledScene& scene = *plan.lines[i].scene;
    results.push_back({lines[i], scene.table_seconds(), bytes_of(scene), {}, {}});
  }
  for (CostRow& row : sweep.rows()) results[row.line].rows.push_back(std::move(row));
  const double relmse = sweep.reference() ? sweep.reference()->relmse : 0;
  for (CostLineResult& result : results) {
    std::vector<CostPoint> points;
    for (const CostRow& row : result.rows) {
      points.push_back({static_cast<double>(row.samples), row.render_seconds, row.relmse});
    }
    result.fit = fit_cost(points, relmse);
  }
  return results;
}

CostResult result_of(const CostSweep& sweep, const CostPlan& plan, const CostArguments& arguments,
                     const std::vector<CostLine>& lines, const RenderOptions& render_options) {
  CostResult result;
  result.scene = render_options.scene;
  result.width = render_options.size.width;
  result.height = render_options.size.height;
  result.threads = render_options.threads > 0 ? render_options.threads
                                              : static_cast<int>(std::thread::hardware_concurrency());
  result.rounds = arguments.rounds;
  result.has_centred_rays = std::any_of(lines.begin(), lines.end(), is_naive);
  result.reference_path = arguments.reference;
  result.reference_samples = plan.reference_samples;
  result.reference_depth = plan.reference.settings.integrator.depth;
  if (sweep.reference() && arguments.reference.empty()) {
    result.reference_seconds = sweep.reference()->seconds;
    result.reference_error = std::sqrt(sweep.reference()->relmse);
  }
  result.lines = results_of(sweep, plan, lines);
  return result;
}

bool report(const CostResult& result, const std::string& base, const CostArguments& arguments,
            ProgressReport& progress, const transport::RenderProgress& last) {
  Diagnostics diagnostics;
  const bool written = write_cost_files(result, base, diagnostics);
  progress.finish(last, base + ".svg");
  fmt::print(stderr, "{}", diagnostics.to_text());
  if (arguments.json) {
    fmt::print("{}", json_of(result, arguments.progress == "json"));
  } else if (arguments.progress != "json") {
    fmt::print("{}\n{}.csv, .md and .svg\n", text_of(result), base);
  }
  return written;
}

int reference_samples_of(const CostArguments& arguments, int most_samples) {
  constexpr int Factor = 16;
  if (arguments.reference_samples > 0) return arguments.reference_samples;
  return most_samples > std::numeric_limits<int>::max() / Factor ? most_samples : Factor * most_samples;
}

}  // namespace

ExitCode cost(const CostArguments& arguments) {
  std::optional<CostSweep> sweep;
  SignalHandler signal_handler;  // destroyed before the sweep that it stops
  Diagnostics diagnostics;
  auto render_options = read_options(arguments.scene, diagnostics);
  if (!render_options) {
    fmt::print(stderr, "{}", diagnostics.to_text());
    return ExitCode::BadInput;
  }
  *render_options = for_sweep(*render_options);
  if (!apply_flags(arguments.flags, *render_options)) return ExitCode::BadCommandLine;
  const auto samples = sample_counts(arguments.samples);
  const auto lines = cost_lines(arguments.sweeps, *render_options);
  if (!samples || !lines || !can_divide(*lines, *samples)) return ExitCode::BadCommandLine;
  const std::string base = base_of(arguments, *render_options);
  CostPlan plan;
  plan.samples = *samples;
  plan.reference_samples = reference_samples_of(arguments, samples->back());
  plan.rounds = arguments.rounds;
  plan.seed = render_options->seed;
  const bool is_ready = can_write(base, diagnostics) &&
                        read_reference(arguments.reference, render_options->size, plan, diagnostics) &&
                        prepare_lines(*lines, *render_options, plan, diagnostics);
  fmt::print(stderr, "{}", diagnostics.to_text());
  if (!is_ready) return ExitCode::BadInput;
  sweep.emplace(plan);
  ProgressReport progress(progress_style_of(arguments.progress));
  run_watched(*sweep, signal_handler, [&] { progress.show(sweep->progress()); });
  const CostResult result = result_of(*sweep, plan, arguments, *lines, *render_options);
  if (!report(result, base, arguments, progress, sweep->progress())) return ExitCode::BadInput;
  return signal_handler.was_signalled() ? ExitCode::Interrupted : ExitCode::Done;
}

}  // namespace command
