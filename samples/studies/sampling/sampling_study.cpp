// Measures the sampling schemes on the BRDFs of the thesis, and compares the figures of its chapter 5 with
// those of today's machine: see README.md beside this file, which it writes.
#include <algorithm>
#include <cstdio>
#include <exception>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "samples/studies/markdown.h"
#include "samples/studies/sampling/report.h"

namespace {

using namespace study;

/// Returns the cases of these names, or nothing if a name is unknown.
std::vector<const Case*> chosen(const std::vector<std::string>& names) {
  std::vector<const Case*> some;
  for (const Case& one : cases()) {
    if (names.empty() || std::count(names.begin(), names.end(), one.name) > 0) some.push_back(&one);
  }
  for (const std::string& name : names) {
    const auto is_it = [&](const Case& one) { return one.name == name; };
    if (std::any_of(cases().begin(), cases().end(), is_it)) continue;
    fmt::print(stderr, "There is no BRDF '{}' among those of the study:", name);
    for (const Case& one : cases()) fmt::print(stderr, " {}", one.name);
    fmt::print(stderr, "\n");
    return {};
  }
  return some;
}

int run(const std::vector<std::string>& names, bool is_quick, const std::string& folder) {
  const std::vector<const Case*> some = chosen(names);
  if (some.empty()) return 2;
  Results results;
  results.effort = is_quick ? Effort::quick() : Effort();
  results.machine = machine_name();
  results.command = "samples/studies/sampling/run";
  if (is_quick) results.command += " --quick";
  if (!names.empty()) results.command += fmt::format(" --only {}", fmt::join(names, ","));
  for (const Case* subject : some) {
    fmt::print(stderr, "{}\n", subject->name);
    results.cases.push_back(measure(*subject, results.effort));
  }
  grf::Diagnostics diagnostics;
  const bool is_written = write_report(results, folder, diagnostics);
  fmt::print(stderr, "{}", diagnostics.to_text());
  return is_written ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Measures the sampling schemes; writes README.md, tables and pictures.");
  bool is_quick = false;
  std::vector<std::string> names;
  std::string folder = ".";
  app.add_flag("--quick", is_quick, "coarse tables, few repeats");
  app.add_option("--only", names, "some of the BRDFs, by name")->delimiter(',');
  app.add_option("-o,--output", folder, "the folder that is written to");
  try {
    app.parse(argc, argv);
    return run(names, is_quick, folder);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
