#include "renderer/command/cost_command.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "grf/write.h"
#include "renderer/command/cost_report.h"
#include "renderer/command/cost_study.h"
#include "renderer/command/cost_sweep.h"
#include "renderer/command/part_arguments.h"
#include "renderer/command/render_output.h"
#include "renderer/command/render_run.h"
#include "renderer/job/render_fingerprint.h"
#include "renderer/job/render_job.h"
#include "renderer/parallel/loops.h"
#include "renderer/transport/sobol.h"

namespace command {
namespace {

using grf::Diagnostics;
using grf::ExitCode;
using options::RenderOptions;
using transport::CompiledScene;
using transport::CropWindow;
using transport::PixelSampling;

bool is_naive(const CostLine& line) { return line.options.integrator == "naive"; }

/// Makes the subjects of lines; lines that need the same tables share a compiled scene.
class Subjects {
 public:
  Subjects(const grf::Scene& scene, bool has_centred_rays, const std::optional<CropWindow>& crop,
           Diagnostics& diagnostics)
      : scene_(scene), has_centred_rays_(has_centred_rays), crop_(crop), diagnostics_(diagnostics) {}

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
    planned->settings.crop = crop_;
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
  const std::optional<CropWindow>& crop_;
  Diagnostics& diagnostics_;
  std::map<std::string, std::shared_ptr<const CompiledScene>> compiled_;
  // Shared by all lines, so read once.
  std::shared_ptr<const transport::EnvironmentMap> environment_;
  std::shared_ptr<const image::Image> backplate_;
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

/// Prepares lines under the conditions of all lines of a study.
bool prepare_lines(const std::vector<CostLine>& lines, const std::vector<CostLine>& all,
                   const RenderOptions& render_options, const std::optional<CropWindow>& crop, CostPlan& plan,
                   Diagnostics& diagnostics) {
  const auto scene = job::read_scene(render_options, diagnostics);
  if (!scene) return false;
  Subjects subjects(*scene, std::any_of(all.begin(), all.end(), is_naive), crop, diagnostics);
  // The first compilation takes longer, because threads start: no line is to be charged for that.
  auto reference = subjects.of(reference_line(all, render_options));
  if (!reference) return false;
  plan.reference = std::move(*reference);
  for (const CostLine& line : lines) {
    auto subject = subjects.of(line);
    if (!subject) return false;
    plan.lines.push_back(std::move(*subject));
  }
  return true;
}

/// Returns false, with an error message, if the crop window is not in the image.
bool read_crop(const CostArguments& arguments, const options::ImageSize& size,
               std::optional<CropWindow>& crop) {
  if (arguments.crop.empty()) return true;
  crop = {arguments.crop[0], arguments.crop[1], arguments.crop[2], arguments.crop[3]};
  const bool is_inside = crop->x >= 0 && crop->y >= 0 && crop->width > 0 && crop->height > 0 &&
                         crop->width <= size.width - crop->x && crop->height <= size.height - crop->y;
  if (!is_inside) {
    fmt::print(stderr, "error: --crop: expected pixels of the image, which has {} x {}\n", size.width,
               size.height);
  }
  return is_inside;
}

bool read_reference(const std::string& path, const options::ImageSize& size, CostPlan& plan,
                    Diagnostics& diagnostics) {
  if (path.empty()) return true;
  auto image = image::read_image(path, diagnostics);
  if (!image) return false;
  plan.given = CostReference{std::move(*image)};
  const image::Image& given = plan.given->image;
  if (given.width == size.width && given.height == size.height) return true;
  diagnostics.error(grf::whole_file(path),
                    fmt::format("the reference has {} x {} pixels, expected {} x {}, the size of the renders",
                                given.width, given.height, size.width, size.height));
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
         can_write_file(base + ".svg", "picture", diagnostics) &&
         can_write_file(base + ".json", "study", diagnostics);
}

std::string reference_file_of(const std::string& base) { return base + "-reference.pfm"; }

/// Returns the conditions under which all lines are measured.
CostConditions conditions_of(const CostArguments& arguments, const std::vector<CostLine>& lines,
                             RenderOptions of_image, const Diagnostics& diagnostics) {
  const RenderOptions defaults;
  static_cast<options::SchemeOptions&>(of_image) = {};
  of_image.integrator = defaults.integrator;
  of_image.depth = defaults.depth;
  of_image.split_count = defaults.split_count;
  of_image.points = defaults.points;
  of_image.precision = defaults.precision;
  of_image.seed = defaults.seed;
  const transport::Fingerprint fingerprint = job::fingerprint_of(of_image, diagnostics.files());
  CostConditions conditions;
  conditions.fingerprint = transport::hex(transport::DigestBuilder()
                                              .add(transport::bytes_of(fingerprint))
                                              .add(fmt::format("{}", fmt::join(arguments.crop, ",")))
                                              .digest());
  conditions.threads = parallel::threads_for(of_image.threads);
  conditions.has_centred_rays = std::any_of(lines.begin(), lines.end(), is_naive);
  return conditions;
}

/// Takes the reference of an earlier study, or checks that it is the one that is there.
bool take_reference(const SavedCost& saved, const std::string& path, CostPlan& plan,
                    Diagnostics& diagnostics) {
  const auto refuse = [&](const char* why) {
    diagnostics.error(grf::whole_file(path), why);
    return false;
  };
  std::optional<image::Image> image;
  if (!saved.reference_image.empty()) {
    image = image::read_image(saved.reference_image, diagnostics);
    if (!image) return false;
  }
  if (plan.given) {
    const std::string digest = image ? digest_of_image(*image) : saved.reference_digest;
    return digest == digest_of_image(plan.given->image) ||
           refuse("the study was measured against another reference: errors would not compare");
  }
  if (!image) return refuse("the study was measured against an image: give it by --reference");
  plan.given = CostReference{std::move(*image), saved.reference_seconds, saved.reference_relmse};
  plan.reference_samples = saved.reference_samples;
  return true;
}

/// Adds the rows of a line that are not known with as many rounds.
void add_known_rows(const SavedCost& saved, const std::string& key, std::size_t line, CostPlan& plan) {
  for (const SavedCost::Row& row : saved.rows) {
    if (row.key != key) continue;
    const auto is_known = [&](const CostRow& known) {
      return known.line == line && known.samples == row.row.samples;
    };
    const auto known = std::ranges::find_if(plan.known, is_known);
    if (known == plan.known.end()) {
      plan.known.push_back(row.row);
      plan.known.back().line = line;
    } else if (known->rounds.size() < row.row.rounds.size()) {
      *known = row.row;
      known->line = line;
    }
  }
}

/// Takes the reference and the rows of the same settings from earlier studies, if there are any.
bool take_earlier(const CostArguments& arguments, const std::vector<CostLine>& lines,
                  const CostConditions& conditions, CostPlan& plan, Diagnostics& diagnostics) {
  for (const std::string& path : arguments.continued) {
    const auto saved = read_cost_study(path, diagnostics);
    if (!saved || !check_conditions(*saved, conditions, path, diagnostics) ||
        !take_reference(*saved, path, plan, diagnostics))
      return false;
    for (std::size_t i = 0; i < lines.size(); ++i) add_known_rows(*saved, key_of(lines[i]), i, plan);
  }
  return true;
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
    results.push_back({lines[i], scene.table_seconds(), bytes_of(scene), {}, {}, {}});
  }
  for (CostRow& row : sweep.rows()) results[row.line].rows.push_back(std::move(row));
  const double relmse = sweep.reference() ? sweep.reference()->relmse : 0;
  std::vector<CostRounds> rounds(results.size());
  for (std::size_t i = 0; i < results.size(); ++i) {
    for (const CostRow& row : results[i].rows) rounds[i][row.samples] = row.rounds;
  }
  const auto efficiencies = efficiencies_of(rounds, relmse);
  for (std::size_t i = 0; i < results.size(); ++i) results[i].efficiency = efficiencies[i];
  for (CostLineResult& result : results) {
    std::vector<CostPoint> points;
    for (const CostRow& row : result.rows) {
      points.push_back({static_cast<double>(row.samples), row.render_seconds, row.relmse});
    }
    result.fit = fit_cost(points, relmse);
  }
  return results;
}

/// What a study is about, which its results repeat.
struct CostTask {
  const CostArguments& arguments;
  const std::vector<CostLine>& lines;
  const RenderOptions& render_options;
  std::string base;
  CostConditions conditions;
  std::optional<CropWindow> crop;
  std::string reference_digest = {};  ///< of a given reference
};

CostResult result_of(const CostSweep& sweep, const CostPlan& plan, const CostTask& task) {
  CostResult result;
  result.scene = task.render_options.scene;
  result.width = task.render_options.size.width;
  result.height = task.render_options.size.height;
  result.crop = task.crop;
  result.rounds = task.arguments.rounds;
  result.conditions = task.conditions;
  result.reference_path = task.arguments.reference;
  result.reference_samples = plan.reference_samples;
  result.reference_depth = plan.reference.settings.integrator.depth;
  result.reference_digest = task.reference_digest;
  if (sweep.reference() && task.arguments.reference.empty()) {
    result.reference_seconds = sweep.reference()->seconds;
    result.reference_error = std::sqrt(sweep.reference()->relmse);
    result.reference_image = grf::file_name(reference_file_of(task.base));
  }
  result.lines = results_of(sweep, plan, task.lines);
  std::vector<std::optional<CostEfficiency>> efficiencies;
  for (const CostLineResult& line : result.lines) efficiencies.push_back(line.efficiency);
  result.winner = winner_of(efficiencies);
  return result;
}

/// Shows progress as `ProgressReport` does and, on JSON lines, the study so far after each measurement.
void watch(const CostSweep& sweep, const CostPlan& plan, const CostTask& task, ProgressReport& progress,
           std::size_t& shown) {
  progress.show(sweep.progress());
  if (task.arguments.progress != "json") return;
  const std::size_t measured = sweep.measured();
  if (measured == shown) return;
  shown = measured;
  fmt::print("{}", json_of(result_of(sweep, plan, task), true));
  std::fflush(stdout);
}

bool report(const CostSweep& sweep, const CostResult& result, const CostTask& task,
            ProgressReport& progress) {
  Diagnostics diagnostics;
  bool written = write_cost_files(result, task.base, diagnostics);
  if (!result.reference_image.empty()) {
    written &= image::write_image({sweep.reference()->image}, reference_file_of(task.base), diagnostics);
  }
  progress.finish(sweep.progress(), task.base + ".svg");
  fmt::print(stderr, "{}", diagnostics.to_text());
  if (task.arguments.json) {
    fmt::print("{}", json_of(result, task.arguments.progress == "json"));
  } else if (task.arguments.progress != "json") {
    fmt::print("{}\n{}.csv, .md, .svg and .json\n", text_of(result), task.base);
  }
  return written;
}

/// Keeps the lines of a part of a study, and gives their rounds seeds that no other part has. Prints errors,
/// and then returns false.
bool take_part(const CostArguments& arguments, std::vector<CostLine>& lines, CostPlan& plan) {
  if (arguments.part.empty()) return true;
  bool is_right = true;
  OptionFlags no_flags;
  const auto part = image_part_of({arguments.part, "", ""}, no_flags, is_right);
  if (!is_right) return false;
  if (arguments.reference.empty()) {
    fmt::print(stderr, "error: --part: the parts of a study share a reference: give it by --reference\n");
    return false;
  }
  if (std::cmp_greater(part->count, lines.size())) {
    fmt::print(stderr, "error: --part: expected at most {} parts, one per line of the study\n", lines.size());
    return false;
  }
  std::vector<CostLine> own;
  for (auto i = static_cast<std::size_t>(part->index); i < lines.size();
       i += static_cast<std::size_t>(part->count))
    own.push_back(std::move(lines[i]));
  lines = std::move(own);
  plan.seed = transport::hash(plan.seed, static_cast<std::uint32_t>(part->index) + 1);
  return true;
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
  const auto all = cost_lines(arguments.sweeps, *render_options);
  if (!samples || !all || !can_divide(*all, *samples)) return ExitCode::BadCommandLine;
  CostPlan plan;
  plan.seed = render_options->seed;
  std::vector<CostLine> lines = *all;
  if (!take_part(arguments, lines, plan)) return ExitCode::BadCommandLine;
  CostTask task = {arguments, lines, *render_options, base_of(arguments, *render_options), {}, {}};
  if (!read_crop(arguments, render_options->size, task.crop)) return ExitCode::BadCommandLine;
  const options::ImageSize size =
      task.crop ? options::ImageSize{task.crop->width, task.crop->height} : render_options->size;
  plan.samples = *samples;
  plan.reference_samples = reference_samples_of(arguments, samples->back());
  plan.rounds = arguments.rounds;
  bool is_ready = can_write(task.base, diagnostics) &&
                  prepare_lines(lines, *all, *render_options, task.crop, plan, diagnostics);
  if (is_ready) {
    // Before the reference is read, which is none of the scene's files.
    task.conditions = conditions_of(arguments, *all, *render_options, diagnostics);
    is_ready = read_reference(arguments.reference, size, plan, diagnostics);
    if (is_ready && plan.given) task.reference_digest = digest_of_image(plan.given->image);
    is_ready = is_ready && take_earlier(arguments, lines, task.conditions, plan, diagnostics);
  }
  fmt::print(stderr, "{}", diagnostics.to_text());
  if (!is_ready) return ExitCode::BadInput;
  sweep.emplace(plan);
  ProgressReport progress(progress_style_of(arguments.progress));
  std::size_t shown = 0;
  run_watched(*sweep, signal_handler, [&] { watch(*sweep, plan, task, progress, shown); });
  watch(*sweep, plan, task, progress, shown);
  if (!report(*sweep, result_of(*sweep, plan, task), task, progress)) return ExitCode::BadInput;
  return signal_handler.was_signalled() ? ExitCode::Interrupted : ExitCode::Done;
}

}  // namespace command
