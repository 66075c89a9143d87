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
      R"(# The test scenes of the thesis, today

`{}` wrote this file, `rows.csv` (each image) and the pictures, on a machine with {}. Every
figure in it and every "holds" is computed from these rows; the thesis' own figures are in `tables.json`, and what cannot be
right in print is said under the table.{}{}

The scenes are `*.op` in this folder, at the sizes of the thesis; the study renders smaller images, of 48x48 pixels (Cornell
box), 64x64 (sphere), 200x200 (dragon), 150x66 and 150x73 (jugs) and 120x120 (one jug){}. So seconds are to be
compared within a table and not with the thesis. What the thesis does not say (views, lights, depths, the constants of
sphere 1, the proposals of resampling, the BRDF of test scene 5) is chosen in the scenes.

- `naive` is the thesis' estimator: N secondary rays at the first hit, by the scheme alone, and no light is sampled. Its
  random numbers are independent here, as the thesis' were. Where a lobe misses part of a BRDF, the image lacks it.
- `path` samples lights too, combines both by multiple importance sampling, and has Sobol points; its N are whole paths.
- `uniform` is the cosine's density, `sphere` and `hemisphere` are cosine lobes (exponent 50; `-best`: the one that comes
  nearest to the BRDF), `factored` has 32x16 cells, J = 2 and K = 1 (`-best`: table 5.6), `cascade` tables of the half
  vector, `reject` is the thesis' method with {}, `warp` is what `adaptive` is today, `own` the BRDF's own sampler.
- Where lights are the only light there is a faint sky, of a 500th to a 30th of their radiance, and in the Cornell box the
  walls glow, by a 3000th: else pixels that a narrow lobe leaves black but for 1e-20 would be all that a mean of relative
  errors shows.
- Sampling times are those in which directions are drawn, of all threads together. Errors are the thesis' average relative
  error against `path` with far more samples; relMSE is in `rows.csv`.

)",
      results.command, results.machine,
      results.effort.is_quick ? " This is the quick run: small images, few samples, coarse trees." : "",
      results.is_whole
          ? ""
          : " Only some scenes or BRDFs were measured, and what is said of claims is said of these.",
      results.effort.is_quick ? ", and here 0.6 times as wide and high" : "",
      results.effort.is_quick ? "20 trees of 200x200 cells" : "60 trees");
}

std::string exponents(const Results& results) {
  if (results.exponents.empty()) return {};
  Table table({"BRDF", "exponent"});
  for (const auto& [name, exponent] : results.exponents) table.add({name, figure(exponent)});
  return "\nThe adjusted exponents of lobes, by the least share of samples that go elsewhere than they "
         "should:\n\n" +
         table.str();
}

std::string table_section(const PrintedTable& printed, const Content& content, const Results& results) {
  return fmt::format("\n### Table {}: {}\n\n", printed.number, printed.title) +
         sweep_table(printed, content, results) + notes(printed);
}

std::string figure_line(const std::string& number, const std::string& words, const std::string& file) {
  return fmt::format("\n### Figure {}\n\n![{}]({})\n\n{}\n", number, words, file, words);
}

constexpr const char* TimeError = "Error over time: the thesis', and today's by `naive` and by `path`.";

std::string cornell(const Results& results, const Printed& printed) {
  const std::string name = "cornell_box";
  if (!results.has(name)) return {};
  return "\n## Test scene 1: the Cornell box\n" +
         table_section(printed.table("5.7"), {name, sampling, {"factored-best", "warp", "own"}}, results) +
         table_section(printed.table("5.8"), {name, percent, {"factored-best", "warp", "own"}}, results) +
         figure_line("5.9", TimeError, "figure_5_9.svg") + sentences(cornell_claims(results, printed)) +
         changes(results, name, printed.table("5.8"));
}

std::string sphere(const Results& results, const Printed& printed) {
  const std::string name = "glossy_sphere";
  if (!results.has(name)) return {};
  const std::vector<std::string_view> more = {"cascade", "warp", "own"};
  return "\n## Test scene 2: the glossy sphere\n" +
         table_section(printed.table("5.9"), {name, sampling, more}, results) +
         table_section(printed.table("5.10"), {name, percent, more}, results) +
         figure_line("5.10", TimeError, "figure_5_10.svg") + sentences(constant_claims(results, printed)) +
         changes(results, name, printed.table("5.10")) +
         figure_line("5.11",
                     "A BRDF of Lewis with kd = ks = 0.5 and n = 32.5, seen at 45 degrees, and cosine lobes.",
                     "figure_5_11.svg") +
         sentences(lobe_claims()) + table_section(printed.table("5.11"), {name, sampling, more}, results) +
         table_section(printed.table("5.12"), {name, percent, more}, results) +
         figure_line("5.12", TimeError, "figure_5_12.svg") + sentences(adjusted_claims(results, printed)) +
         changes(results, name, printed.table("5.12")) + exponents(results);
}

/// What the thesis says of figure 5.13 in its caption, as a table like the others.
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
  return "\n## Test scene 3: a dragon\n\nThe mesh of `make_shape` with about 200,000 triangles stands in for "
         "Stanford's.\n" +
         figure_line("5.13",
                     "100 samples by `naive`; from the left uniform, adjusted lobes, factors, the thesis' "
                     "method, and `warp`.",
                     "figure_5_13.png") +
         "\n" + sweep_table(times, {name, sampling, ours}, results) + "\n" +
         sweep_table(errors, {name, percent, all}, results) + sentences(dragon_claims(results)) +
         changes(results, name, errors);
}

std::string pottery(const Results& results, const Printed& printed) {
  const std::string name = "pottery";
  if (!results.has(name)) return {};
  const std::vector<std::string_view> more = {
      "uniform", "hemisphere-best", "factored-best", "cascade", "warp", "own"};
  return "\n## Test scene 4: three jugs\n\n`factored-fine` is what the thesis calls pottery3, 32x16 views "
         "and 64x32 cells, with the "
         "factors of table 5.6.\n" +
         figure_line(
             "5.14",
             "196 samples by `naive`; from the top uniform, lobes, factors, the thesis' method, and `warp`.",
             "figure_5_14.png") +
         table_section(printed.table("5.13"), {name, build, more}, results) +
         table_section(printed.table("5.14"), {name, sampling, more}, results) +
         table_section(printed.table("5.15"), {name, percent, more}, results) +
         figure_line("5.15", TimeError, "figure_5_15.svg") + sentences(pottery_claims(results, printed)) +
         changes(results, name, printed.table("5.15"));
}

std::string jug(const Results& results, const Printed& printed) {
  const std::string name = "jug";
  if (!results.has(name)) return {};
  const std::vector<std::string_view> more = {"uniform",  "cascade", "cascade-ris", "warp",
                                              "warp-ris", "own",     "own-ris"};
  return "\n## Test scene 5: a jug, an environment map and resampling\n\nResampling chooses 1 of 8 "
         "proposals, and is done by `path`. "
         "Without it, `naive` is what the thesis did, and `path` samples the map as well.\n" +
         table_section(printed.table("5.16"), {name, build, more}, results) +
         table_section(printed.table("5.17"), {name, sampling, more}, results) +
         table_section(printed.table("5.18"), {name, percent, more}, results) +
         figure_line("5.16", TimeError, "figure_5_16.svg") + sentences(jug_claims(results, printed)) +
         changes(results, name, printed.table("5.18"));
}

std::string measured(const Results& results, const Printed& printed) {
  if (!results.has("measured")) return {};
  const PrintedTable& before = printed.table("5.19");
  const PrintedTable& times = printed.table("5.20");
  return fmt::format(
             "\n## Test scene 7: measured BRDFs\n\n{} 25 samples by `naive`. Tables have 256x32 cells, and "
             "compressed ones {} (the thesis: 1024x512).\n\n### Table 5.19: {}\n\n",
             results.has_merl ? "The tables are those of the MERL data base."
                              : "The tables are those of analytic BRDFs that stand in for the materials, by "
                                "`bpt brdf export`; with "
                                "`--merl FOLDER` they are those of the data base.",
             results.effort.is_quick ? "256x32" : "1024x256", before.title) +
         precomputation_table(before, results) + notes(before) +
         fmt::format("\n### Table 5.20: {}\n\n", times.title) + material_times_table(times, results) +
         notes(times) + sentences(measured_claims(results, printed)) + changes(results, "measured", times);
}

struct Figure {
  std::string scene, file, times, errors;
};

bool write_charts(const Results& results, const Printed& printed, const std::string& folder,
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

bool write_report(const Results& results, const Printed& printed, const std::string& folder,
                  grf::Diagnostics& diagnostics) {
  const std::string readme = introduction(results) + cornell(results, printed) + sphere(results, printed) +
                             dragon(results) + pottery(results, printed) + jug(results, printed) +
                             measured(results, printed) + equal_time_section(results);
  return grf::replace_file(folder + "/README.md", readme, diagnostics) &&
         grf::replace_file(folder + "/rows.csv", csv(results), diagnostics) &&
         write_charts(results, printed, folder, diagnostics);
}

}  // namespace study
