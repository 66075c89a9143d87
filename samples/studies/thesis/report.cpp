#include "samples/studies/thesis/report.h"

#include <fmt/format.h>

#include "grf/text_file.h"
#include "samples/studies/markdown.h"
#include "samples/studies/thesis/charts.h"
#include "samples/studies/thesis/claims.h"
#include "samples/studies/thesis/equal_time.h"
#include "samples/studies/thesis/tables.h"

namespace study {
namespace {

std::string introduction(const Results& results) {
  return fmt::format(
      R"(# The thesis' test scenes, rendered today

This study renders the test scenes of the thesis' chapter 5 and compares its tables of sampling time and error with today's.
`{}` wrote this file, `rows.csv` (one row per image) and the pictures, on a machine with {}. Every
figure in it and every "holds" is computed from these rows; the thesis' own figures are in `tables.json`, and misprints are
noted under each table.{}{}

The scenes are `*.op` in this folder, at the sizes of the thesis; the study renders smaller images, of 48x48 pixels (Cornell
box), 64x64 (sphere), 200x200 (dragon), 150x66 and 150x73 (jugs) and 120x120 (one jug){}. So compare seconds
within a table, not with the thesis. What the thesis does not specify (views, lights, depths, the constants of sphere 1,
the proposals of resampling, the BRDF of test scene 5) is chosen in the scenes.

- `naive` is the thesis' estimator: N secondary rays at the first hit, sampled by the scheme only, without light sampling.
  Its random numbers are independent here, as in the thesis. Where a lobe misses part of a BRDF, the image is biased: that
  part is missing.
- `path` is path tracing with Sobol points, which also samples lights and combines both by multiple importance sampling;
  its N are whole paths.
- `uniform` is cosine-weighted sampling, `sphere` and `hemisphere` are cosine lobes (exponent 50; `-best`: the exponent that
  fits the BRDF best), `factored` has 32x16 cells, J = 2 and K = 1 (`-best`: table 5.6), `cascade` has tables of the half
  vector, `reject` is the thesis' method with {}, `warp` is today's `adaptive`, `own` is the BRDF's own sampler.
- Scenes that are lit by area lights only have a faint sky of 1/500 to 1/30 of their radiance, and in the Cornell box the
  walls emit 1/3000: otherwise pixels that are almost black (1e-20) under a narrow lobe would dominate the mean relative
  error.
- Sampling times are the time spent sampling directions, summed over threads. Errors are the thesis' average relative
  error against `path` with far more samples; relMSE is in `rows.csv`.

)",
      results.command, results.machine,
      results.effort.is_quick ? " This is the quick run: small images, few samples, coarse quadtrees." : "",
      results.is_whole
          ? ""
          : " Only some scenes or BRDFs were measured, and the verdicts on claims are for these only.",
      results.effort.is_quick ? ", and here 0.6 times as wide and high" : "",
      results.effort.is_quick ? "20 quadtrees of 200x200 cells" : "60 quadtrees");
}

std::string exponents(const Results& results) {
  if (results.exponents.empty()) return {};
  Table table({"BRDF", "exponent"});
  for (const auto& [name, exponent] : results.exponents) table.add({name, figure(exponent)});
  return "\nThese are the adjusted exponents of lobes, with the least total variation distance between pdf "
         "and f cos / albedo:\n\n" +
         table.str();
}

std::string table_section(const PrintedTable& printed, const Content& content, const Results& results) {
  return fmt::format("\n### Table {}: {}\n\n", printed.number, printed.title) +
         sweep_table(printed, content, results) + notes(printed);
}

std::string figure_line(const std::string& number, const std::string& words, const std::string& file) {
  return fmt::format("\n### Figure {}\n\n![{}]({})\n\n{}\n", number, words, file, words);
}

constexpr const char* TimeError = "Error over time: the thesis' figures, and today's by `naive` and `path`.";

std::string cornell(const Results& results, const PrintedTables& printed) {
  const std::string name = "cornell_box";
  if (!results.has(name)) return {};
  return "\n## Test scene 1: the Cornell box\n" +
         table_section(printed.table("5.7"), {name, sampling, {"factored-best", "warp", "own"}}, results) +
         table_section(printed.table("5.8"), {name, percent, {"factored-best", "warp", "own"}}, results) +
         figure_line("5.9", TimeError, "figure_5_9.svg") + sentences(cornell_claims(results, printed)) +
         changes(results, name, printed.table("5.8"));
}

std::string sphere(const Results& results, const PrintedTables& printed) {
  const std::string name = "glossy_sphere";
  if (!results.has(name)) return {};
  const std::vector<std::string_view> more = {"cascade", "warp", "own"};
  return "\n## Test scene 2: the glossy sphere\n" +
         table_section(printed.table("5.9"), {name, sampling, more}, results) +
         table_section(printed.table("5.10"), {name, percent, more}, results) +
         figure_line("5.10", TimeError, "figure_5_10.svg") + sentences(constant_claims(results, printed)) +
         changes(results, name, printed.table("5.10")) +
         figure_line("5.11",
                     "The Lewis BRDF with kd = ks = 0.5 and n = 32.5, viewed at 45 degrees, and the pdfs of "
                     "cosine lobes.",
                     "figure_5_11.svg") +
         sentences(lobe_claims()) + table_section(printed.table("5.11"), {name, sampling, more}, results) +
         table_section(printed.table("5.12"), {name, percent, more}, results) +
         figure_line("5.12", TimeError, "figure_5_12.svg") + sentences(adjusted_claims(results, printed)) +
         changes(results, name, printed.table("5.12")) + exponents(results);
}

/// Returns the figures in the thesis' caption of figure 5.13 as a table.
PrintedTable caption_of_dragon() {
  PrintedTable table;
  table.number = "5.13";
  table.unit = "sampling time, s";
  table.columns = {"100"};
  table.samples = {100};
  table.rows = {{"Uniform", "uniform", {9.749}},
                {"CosLobe Ω", "hemisphere-best", {29.06}},
                {"Factored BRDF", "factored-best", {24.539}},
                {"Adaptive Disc", "reject", {42.632}}};
  return table;
}

std::string dragon(const Results& results) {
  const std::string name = "dragon";
  if (!results.has(name)) return {};
  PrintedTable times = caption_of_dragon();
  PrintedTable errors = times;
  errors.unit = "error, %";
  errors.rows.clear();
  const std::vector<std::string_view> ours = {"warp", "own"};
  const std::vector<std::string_view> all = {"uniform", "hemisphere-best", "factored-best", "reject", "warp",
                                             "own"};
  return "\n## Test scene 3: a dragon\n\nA mesh of `make_shape` with about 200,000 triangles replaces the "
         "Stanford dragon.\n" +
         figure_line("5.13",
                     "`naive` with 100 samples; from left to right uniform, adjusted lobes, factors, the "
                     "thesis' method, and `warp`.",
                     "figure_5_13.png") +
         "\n" + sweep_table(times, {name, sampling, ours}, results) + "\n" +
         sweep_table(errors, {name, percent, all}, results) + sentences(dragon_claims(results)) +
         changes(results, name, errors);
}

std::string pottery(const Results& results, const PrintedTables& printed) {
  const std::string name = "pottery";
  if (!results.has(name)) return {};
  const std::vector<std::string_view> more = {
      "uniform", "hemisphere-best", "factored-best", "cascade", "warp", "own"};
  return "\n## Test scene 4: three jugs\n\n`factored-fine` is the thesis' pottery3, 32x16 views and 64x32 "
         "cells, with the factors of table 5.6.\n" +
         figure_line("5.14",
                     "`naive` with 196 samples; from top to bottom uniform, lobes, factors, the thesis' "
                     "method, and `warp`.",
                     "figure_5_14.png") +
         table_section(printed.table("5.13"), {name, build, more}, results) +
         table_section(printed.table("5.14"), {name, sampling, more}, results) +
         table_section(printed.table("5.15"), {name, percent, more}, results) +
         figure_line("5.15", TimeError, "figure_5_15.svg") + sentences(pottery_claims(results, printed)) +
         changes(results, name, printed.table("5.15"));
}

std::string jug(const Results& results, const PrintedTables& printed) {
  const std::string name = "jug";
  if (!results.has(name)) return {};
  const std::vector<std::string_view> more = {"uniform",  "cascade", "cascade-ris", "warp",
                                              "warp-ris", "own",     "own-ris"};
  return "\n## Test scene 5: a jug, an environment map and resampling\n\nResampled importance sampling "
         "chooses 1 of 8 proposals, and is done by `path`. Without it, `naive` is the thesis' estimator, and "
         "`path` also samples the environment map.\n" +
         table_section(printed.table("5.16"), {name, build, more}, results) +
         table_section(printed.table("5.17"), {name, sampling, more}, results) +
         table_section(printed.table("5.18"), {name, percent, more}, results) +
         figure_line("5.16", TimeError, "figure_5_16.svg") + sentences(jug_claims(results, printed)) +
         changes(results, name, printed.table("5.18"));
}

std::string measured(const Results& results, const PrintedTables& printed) {
  if (!results.has("measured")) return {};
  const PrintedTable& before = printed.table("5.19");
  const PrintedTable& times = printed.table("5.20");
  return fmt::format(
             "\n## Test scene 7: measured BRDFs\n\n{} Images have 25 samples by `naive`. Tables of `cascade` "
             "have 256x32 cells, and compressed ones {} (the thesis: 1024x512).\n\n### Table 5.19: {}\n\n",
             results.has_merl ? "The BRDFs are those of the MERL data base."
                              : "The BRDFs are tables of analytic models that replace the measured "
                                "materials, made by `bpt brdf export`; with `--merl FOLDER` they are those "
                                "of the MERL data base.",
             results.effort.is_quick ? "256x32" : "1024x256", before.title) +
         precomputation_table(before, results) + notes(before) +
         fmt::format("\n### Table 5.20: {}\n\n", times.title) + material_times_table(times, results) +
         notes(times) + sentences(measured_claims(results, printed)) + changes(results, "measured", times);
}

struct Figure {
  std::string scene, file, times, errors;
};

bool write_charts(const Results& results, const PrintedTables& printed, const std::string& folder,
                  grf::Diagnostics& diagnostics) {
  const Figure figures[] = {{"cornell_box", "figure_5_9.svg", "5.7", "5.8"},
                            {"glossy_sphere", "figure_5_10.svg", "5.9", "5.10"},
                            {"glossy_sphere", "figure_5_12.svg", "5.11", "5.12"},
                            {"pottery", "figure_5_15.svg", "5.14", "5.15"},
                            {"jug", "figure_5_16.svg", "5.17", "5.18"}};
  bool written = true;
  for (const Figure& one : figures) {
    if (!results.has(one.scene)) continue;
    written &= plot::write_picture(
        time_error_chart(results, one.scene, printed.table(one.times), printed.table(one.errors)),
        folder + "/" + one.file, diagnostics);
  }
  if (results.has("glossy_sphere")) {
    written &= plot::write_picture(lobe_chart(), folder + "/figure_5_11.svg", diagnostics);
  }
  return written;
}

}  // namespace

bool write_report(const Results& results, const PrintedTables& printed, const std::string& folder,
                  grf::Diagnostics& diagnostics) {
  const std::string readme = introduction(results) + cornell(results, printed) + sphere(results, printed) +
                             dragon(results) + pottery(results, printed) + jug(results, printed) +
                             measured(results, printed) + equal_time_section(results);
  return grf::replace_file(folder + "/README.md", readme, diagnostics) &&
         grf::replace_file(folder + "/rows.csv", csv(results), diagnostics) &&
         write_charts(results, printed, folder, diagnostics);
}

}  // namespace study
