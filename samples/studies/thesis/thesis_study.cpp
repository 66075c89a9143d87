// Renders the test scenes of the thesis, and writes the tables of its chapter 5 with today's figures to
// README.md beside this file.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "grf/text_file.h"
#include "samples/studies/markdown.h"
#include "samples/studies/sampling/cases.h"
#include "samples/studies/thesis/lobe_fit.h"
#include "samples/studies/thesis/measure.h"
#include "samples/studies/thesis/pictures.h"
#include "samples/studies/thesis/report.h"

namespace {

using namespace study;

struct Arguments {
  bool is_quick = false;
  bool has_rows = false;  ///< rows are read from rows.csv beside the report, of an earlier run
  std::vector<std::string> names;
  std::string merl, output = ".", work = "work";
};

bool is_scene(const std::string& name) {
  return std::find(std::begin(SceneNames), std::end(SceneNames), name) != std::end(SceneNames);
}

std::vector<std::string> brdf_names() {
  std::vector<std::string> names;
  for (const Case& one : cases()) names.push_back(one.name);
  for (const Material& one : materials()) names.push_back(one.name);
  return names;
}

/// Returns nothing after an unknown name, which is reported.
std::optional<Choice> choice_of(const Arguments& arguments) {
  Choice choice;
  const std::vector<std::string> brdfs = brdf_names();
  for (const std::string& name : arguments.names) {
    if (is_scene(name)) {
      choice.scenes.push_back(name);
    } else if (std::find(brdfs.begin(), brdfs.end(), name) != brdfs.end()) {
      choice.brdfs.push_back(name);
    } else {
      fmt::print(stderr, "error: --only: found '{}', expected scenes or BRDFs: {}, {}\n", name,
                 fmt::join(SceneNames, ", "), fmt::join(brdfs, ", "));
      return std::nullopt;
    }
  }
  choice.effort.is_quick = arguments.is_quick;
  choice.folder = GRANADA_SOURCE_DIR "/samples/studies/thesis";
  std::filesystem::create_directories(arguments.work);
  choice.data = std::filesystem::absolute(arguments.work).string();
  for (const Case& one : cases()) choice.exponents[one.name] = best_lobe_exponent(brdf_of(one.brdf));
  return choice;
}

std::string command_of(const Arguments& arguments) {
  std::string command = "samples/studies/thesis/run";
  if (arguments.is_quick) command += " --quick";
  if (!arguments.names.empty()) command += fmt::format(" --only {}", fmt::join(arguments.names, ","));
  if (!arguments.merl.empty()) command += " --merl FOLDER";
  return command;
}

void measure_all(const std::vector<Group>& groups, const Programs& programs, const std::string& work,
                 Results& results) {
  for (const Group& group : groups) {
    const auto start = std::chrono::steady_clock::now();
    for (Row& row : measure(group, programs, work)) results.rows.push_back(std::move(row));
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    fmt::print(stderr, "{}: {:.1f} s\n", group.file, seconds);
  }
}

void measure_and_draw(const Choice& choice, const Arguments& arguments, Results& results) {
  const Programs programs(std::filesystem::read_symlink("/proc/self/exe").parent_path().string(),
                          choice.data + "/log");
  prepare(choice, programs, arguments.merl);
  const std::vector<Group> all = groups(choice);
  measure_all(all, programs, choice.data, results);
  for (const auto& [row, file] :
       {std::pair(dragon_pictures(), "figure_5_13.png"), std::pair(pottery_pictures(), "figure_5_14.png")}) {
    if (choice.has_scene(row.scene))
      write_pictures(row, all, programs, choice.data, arguments.output + "/" + file);
  }
}

int run(const Arguments& arguments) {
  grf::Diagnostics diagnostics;
  const auto choice = choice_of(arguments);
  if (!choice) return 2;
  const auto printed = read_printed(choice->folder + "/tables.json", diagnostics);
  if (!printed) {
    fmt::print(stderr, "{}", diagnostics.to_text());
    return 1;
  }
  Results results;
  results.effort = choice->effort;
  results.machine = machine_name();
  results.command = command_of(arguments);
  results.is_whole = arguments.names.empty();
  results.has_merl = !arguments.merl.empty();
  if (choice->has_scene("glossy_sphere")) results.exponents = choice->exponents;
  if (arguments.has_rows) {
    const auto rows = grf::read_file(arguments.output + "/rows.csv", diagnostics);
    if (rows) results.rows = rows_of_csv(*rows);
  } else {
    measure_and_draw(*choice, arguments, results);
    results.rows =
        rows_of_csv(csv(results));  // rounded as in the file, so that --report gives the same report
  }
  const bool is_written =
      !diagnostics.has_errors() && write_report(results, *printed, arguments.output, diagnostics);
  fmt::print(stderr, "{}", diagnostics.to_text());
  return is_written ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Render the test scenes of the thesis, and write README.md, tables and pictures.");
  Arguments arguments;
  app.add_flag("--quick", arguments.is_quick, "small images, few samples, coarse quadtrees");
  app.add_flag("--report", arguments.has_rows, "rewrite the report from rows.csv without rendering");
  app.add_option("--only", arguments.names, "names of scenes or BRDFs to render")->delimiter(',');
  app.add_option("--merl", arguments.merl, "folder with files of the MERL data base")
      ->check(CLI::ExistingDirectory);
  app.add_option("-o,--output", arguments.output, "output folder of the report");
  app.add_option("--work", arguments.work, "folder for generated scenes and meshes");
  try {
    app.parse(argc, argv);
    return run(arguments);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
