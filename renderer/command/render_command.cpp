#include "renderer/command/render_command.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <optional>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <pthread.h>
#include <sys/resource.h>

#include "grf/check.h"
#include "grf/read.h"
#include "renderer/command/progress_bar.h"
#include "renderer/command/render_output.h"
#include "renderer/command/render_reports.h"
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
  auto scene = grf::read(path, diagnostics);
  if (!scene || !grf::check(*scene, reflectance::catalogue(), diagnostics) || !has_scheme) {
    return std::nullopt;
  }
  auto compiled = transport::compile(std::move(*scene), diagnostics, settings);
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
  if (map) settings.integrator.environment = std::make_shared<const transport::EnvironmentMap>(std::move(*map));
  if (render_options.resampling) {
    settings.integrator.resampling = {render_options.resampling->first, render_options.resampling->second};
  }
  return map.has_value();
}

transport::RenderSettings settings_of(const RenderOptions& render_options, const grf::Box3d& bounds) {
  transport::RenderSettings settings;
  settings.width = render_options.size.width;
  settings.height = render_options.size.height;
  const float aspect = static_cast<float>(settings.width) / static_cast<float>(settings.height);
  settings.view = transport::view_of(bounds, render_options.field_of_view, aspect);
  if (render_options.viewer) settings.view.eye = *render_options.viewer;
  if (render_options.target) settings.view.target = *render_options.target;
  settings.view.up = render_options.up;
  settings.integrator.background = render_options.background;
  settings.integrator.depth = render_options.depth;
  settings.integrator.measures_sampling = render_options.writes_sampling_time;
  settings.samples = render_options.samples_a_pixel();
  settings.seed = render_options.seed;
  settings.threads = render_options.threads;
  return settings;
}

/// SIGINT and SIGTERM, held back from all threads that start from now on, so that one thread can wait for
/// them: no handler interrupts anything half done.
class HeldSignals {
 public:
  HeldSignals() {
    sigemptyset(&set_);
    sigaddset(&set_, SIGINT);
    sigaddset(&set_, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &set_, &before_);
  }
  HeldSignals(const HeldSignals&) = delete;
  HeldSignals& operator=(const HeldSignals&) = delete;
  ~HeldSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

  /// Waits for a signal for at most this long; true if one came.
  bool wait(std::chrono::milliseconds time) const {
    const timespec timeout = {time.count() / 1000, (time.count() % 1000) * 1'000'000};
    return sigtimedwait(&set_, nullptr, &timeout) > 0;
  }

 private:
  sigset_t set_ = {};
  sigset_t before_ = {};
};

/// Runs the render to its end, or to a signal; true if it was interrupted.
bool run(transport::Render& render) {
  const HeldSignals signals;
  std::atomic<bool> ended = false;
  std::exception_ptr failure;
  std::thread worker([&] {
    try {
      render.run();
    } catch (...) {
      failure = std::current_exception();
    }
    ended = true;
  });
  ProgressBar bar;
  bool interrupted = false;
  while (!ended) {
    if (signals.wait(std::chrono::milliseconds(20))) {
      interrupted = true;
      render.stop();
    }
    bar.show(render.progress());
  }
  worker.join();
  if (failure) std::rethrow_exception(failure);
  return interrupted;
}

std::size_t peak_memory_bytes() {
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

nlohmann::json summary_of(const transport::Render& render, const RenderOptions& render_options,
                          const std::string& output, double setup_seconds, const CompiledScene& scene) {
  const double seconds = render.seconds();
  const auto error = render.film().estimated_error();
  const double pixels = static_cast<double>(render_options.size.width) * render_options.size.height;
  nlohmann::json summary;
  summary["output"] = output;
  summary["width"] = render_options.size.width;
  summary["height"] = render_options.size.height;
  summary["samples"] = render_options.samples_a_pixel();
  if (render.is_stopped()) summary["samples"] = static_cast<double>(render.path_count()) / pixels;
  summary["setup_seconds"] = setup_seconds;
  summary["render_seconds"] = seconds;
  summary["paths_per_second"] = static_cast<double>(render.path_count()) / seconds;
  summary["rays_per_second"] = static_cast<double>(render.ray_count()) / seconds;
  summary["estimated_error"] = error ? nlohmann::json(*error) : nlohmann::json(nullptr);
  summary["peak_memory_bytes"] = peak_memory_bytes();
  summary["effects"] = scene.effects().names();
  return summary;
}

void print(const nlohmann::json& summary, bool json) {
  if (json) {
    fmt::print("{}\n", summary.dump(2));
    return;
  }
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
bool keep(const transport::Render& render, const CompiledScene& scene, const transport::View& view,
          const RenderOptions& render_options, const std::vector<std::string>& outputs) {
  Diagnostics diagnostics;
  if (render.rejected_samples() > 0) {
    diagnostics.warning(
        {}, fmt::format("{} samples were not finite and count as black", render.rejected_samples()));
  }
  const transport::ImageFile file = image_file_of(render, scene, view, render_options);
  const std::vector<std::string> fallbacks = transport::fallback_folders();
  bool kept = true;
  for (const std::string& output : outputs) {
    kept &= transport::keep_image(file, output, fallbacks, diagnostics);
  }
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
  if (!can_write(outputs, render_options, diagnostics)) return std::nullopt;
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

}  // namespace

grf::ExitCode render(const RenderArguments& arguments) {
  const auto start = Clock::now();
  Diagnostics diagnostics;
  auto render_options = read_options(arguments.scene, diagnostics);
  std::vector<std::string> outputs;
  std::optional<Job> job;
  if (render_options) {
    if (!apply_flags(arguments, *render_options)) return ExitCode::BadCommandLine;
    outputs = outputs_of(arguments, *render_options);
    job = prepare(*render_options, outputs, diagnostics);
  }
  print(diagnostics);
  if (!job) return ExitCode::BadInput;
  transport::Render render(job->scene, job->settings);
  const double setup_seconds = std::chrono::duration<double>(Clock::now() - start).count();
  const bool interrupted = run(render);
  if (!keep(render, job->scene, job->settings.view, *render_options, outputs)) return ExitCode::BadInput;
  print(summary_of(render, *render_options, outputs.front(), setup_seconds, job->scene), arguments.json);
  return interrupted ? ExitCode::Interrupted : ExitCode::Done;
}

}  // namespace command
