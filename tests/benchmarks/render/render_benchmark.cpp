// Renders the benchmark's scenes with bpt, and on request with Blender's Cycles in turn, and reports
// their speed and accuracy: see tests/benchmarks/README.md.
#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "grf/text_file.h"
#include "tests/benchmarks/render/command_line.h"
#include "tests/benchmarks/render/report.h"

namespace {

using benchmark::Measurement;
using benchmark::SceneFiles;

struct Arguments {
  benchmark::Settings settings;
  std::string folder = "build/benchmarks/render";
  std::vector<std::string> scenes;
  bool cycles = false;
  bool quick = false;
  bool without_embree = false;
};

void add_options(CLI::App& app, Arguments& arguments) {
  benchmark::Settings& settings = arguments.settings;
  app.add_option("--folder", arguments.folder, "folder for scenes, images, references and results")
      ->capture_default_str();
  app.add_option("--scenes", arguments.scenes,
                 "names of scenes, see tests/benchmarks/README.md; all by default")
      ->delimiter(',');
  app.add_option("--size", settings.size, "width and height, pixels")
      ->check(CLI::Range(1, 8192))
      ->capture_default_str();
  app.add_option("--samples", settings.samples, "samples per pixel; references have 64 times as many")
      ->check(CLI::Range(1, 1'000'000))
      ->capture_default_str();
  app.add_option("--rounds", settings.rounds, "repetitions of each measurement, each with its own seed")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--threads", settings.threads)->check(CLI::Range(1, 1024))->capture_default_str();
  app.add_flag("--cycles", arguments.cycles, "also measure Blender's Cycles, in turn with bpt");
  app.add_flag("--fresh", settings.fresh, "render the references again, after a change of what bpt computes");
  app.add_flag("--without-embree-share", arguments.without_embree,
               "do not measure the time spent in Embree and the rays by kind");
  app.add_flag("--quick", arguments.quick, "tiny meshes, images and references: a smoke test");
}

/// Returns the requested scenes; throws if one does not exist.
std::vector<SceneFiles> selected(std::vector<SceneFiles> scenes, const std::vector<std::string>& names) {
  if (names.empty()) return scenes;
  std::vector<SceneFiles> wanted;
  for (const std::string& name : names) {
    const auto found = std::find_if(scenes.begin(), scenes.end(),
                                    [&](const SceneFiles& scene) { return scene.name == name; });
    if (found == scenes.end()) throw std::runtime_error("unknown scene '" + name + "'");
    wanted.push_back(*found);
  }
  return wanted;
}

bool keep(const std::string& folder, const std::vector<Measurement>& measurements) {
  grf::Diagnostics diagnostics;
  const bool kept =
      grf::replace_file(folder + "/results.md", to_markdown(measurements), diagnostics) &&
      grf::replace_file(folder + "/results.csv", to_csv(measurements), diagnostics) &&
      grf::replace_file(folder + "/results.json", to_json(measurements).dump(2) + "\n", diagnostics);
  fmt::print(stderr, "{}", diagnostics.to_text());
  return kept;
}

int run(Arguments arguments) {
  benchmark::Settings& settings = arguments.settings;
  if (arguments.quick) {
    settings.size = 24;
    settings.samples = 2;
    settings.rounds = 1;
  }
  settings.folder = arguments.folder + "/images";
  settings.measures_embree = !arguments.without_embree;
  settings.renderers = {benchmark::Renderer::Bpt};
  if (arguments.cycles) {
    fmt::print("{}\n", benchmark::required_blender_version());
    settings.renderers.push_back(benchmark::Renderer::Cycles);
  }
  const auto scenes =
      selected(benchmark::make_scenes(arguments.folder + "/scenes", arguments.quick), arguments.scenes);
  std::vector<Measurement> measurements;
  for (const SceneFiles& scene : scenes) {
    const auto of_scene =
        measure(scene, settings, [](const std::string& text) { fmt::print(stderr, "{}\n", text); });
    measurements.insert(measurements.end(), of_scene.begin(), of_scene.end());
  }
  fmt::print("{}x{} pixels, {} samples per pixel, {} threads, {} rounds\n\n{}", settings.size, settings.size,
             settings.samples, settings.threads, settings.rounds, to_markdown(measurements));
  return keep(arguments.folder, measurements) ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Measures bpt on the benchmark's scenes");
  Arguments arguments;
  add_options(app, arguments);
  return benchmark::run_command_line(app, argc, argv, [&] { return run(std::move(arguments)); });
}
