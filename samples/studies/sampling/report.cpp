#include "samples/studies/sampling/report.h"

#include <cmath>

#include <fmt/format.h>

#include "grf/text_file.h"
#include "samples/studies/sampling/charts.h"
#include "samples/studies/sampling/claims.h"
#include "samples/studies/sampling/tables.h"

namespace study {
namespace {

std::string introduction(const Results& results) {
  return fmt::format(R"(# What sampling schemes cost and what they give

`{}` wrote this file, `sampling.csv` (every error), `tables.csv` (every other figure) and the
pictures, on a machine with {}. Times are the least of some tries
(of one, where that takes over five seconds), and other work on the machine lengthens them. Errors depend on the points alone.{}

The BRDFs are those of table 5.5 of Montes' thesis (2008). A BRDF is called glossy, and has a star in the tables of errors, if
its model has a lobe. The deviation is the relative error of one sample under light from everywhere. Exponents of lobes are 50 or, "best", those of least deviation; `factored` has the parameters that fit
best (below); nothing is set for the others.{}

{})",
                     results.command, results.machine,
                     results.effort.is_quick
                         ? fmt::format(" This is the quick run: few repeats, {} cells along the edge of the "
                                       "grid of `reject` where 800 are usual, and a short search.",
                                       results.effort.resolution)
                         : "",
                     results.cases.size() == cases().size()
                         ? ""
                         : " Here are only some of them, and what is said of claims is said of these.",
                     choice_table(results));
}

std::string thesis_tables(const Results& results) {
  std::string text = "\n## Time to build (table 5.1)\n\nSeconds for 60 and 90 trees with one azimuth. ";
  text +=
      "Factors are those of table 5.6, and those that were found below; for isotropic BRDFs u needs no "
      "azimuth, which the thesis had 16 of.\n\n";
  text += build_table(results) + sentences(build_claims(results));
  text +=
      "\n## Memory of one tree against n_max (table 5.2)\n\nKB for `mode=reject` and a view at 45 degrees, "
      "without the table of values that it was made from. The thesis does not say which view it took.\n\n";
  text += tree_table(results) + sentences(tree_claims(results));
  text +=
      "\n## Memory of the trees and of the factors (table 5.3)\n\nKB; `reject` without its tables, as the "
      "thesis has it (`release=true`).\n\n";
  text += memory_table(results) + sentences(memory_claims(results));
  text +=
      "\n## Parameters of the factors (table 5.6)\n\nThe distance is the share of samples that go elsewhere "
      "than they should, half the integral of |density - f cos / albedo|, in the mean over views at 20, 45 "
      "and 70 degrees. Found: the least distance of all J and K up to ";
  text += fmt::format(
      "{}, directions and half vectors, and 32x16, 100x32 and 200x32 cells; of those within a fiftieth of "
      "it, the one with the smallest tables.\n\n",
      results.effort.most_factors);
  return text + factor_table(results) + sentences(factor_claims(results));
}

std::string errors(const Results& results) {
  std::string text = fmt::format(
      "\n## Error at equal samples\n\nThe relative error of the light that is reflected, root mean square "
      "over {} estimates of 256 points each and over views at 20, 45 and 70 degrees. The lights: a "
      "small one that may be anywhere, of which the errors of all places add up as in a picture of a sphere "
      "(anywhere); a sky with a hazy sun and ground (environment); and discs of 5 degrees in radius at the "
      "mirror direction (highlight) and 30 degrees from it (beside). Errors are relative to no less than a "
      "thousandth of what a white matte surface reflects. The least of the generic schemes is bold; `own` is "
      "the model's own sampler. A scheme that would miss part of a BRDF is mixed with a cosine part, as in "
      "images. Points are those of a scrambled Sobol sequence, as images have them, or independent, as the "
      "thesis had them and its claims are judged by. A difference within twice its standard error counts as "
      "none.\n\n"
      "![Error of each scheme](schemes.svg)\n\n![Error over samples](convergence.svg)\n",
      results.effort.repeats);
  for (const Light light : LightsByWeight) {
    text += fmt::format("\n### {}\n\n", LightNames[light]) + error_table(results, light, Sobol) + "\n" +
            error_table(results, light, Independent);
    text += sentences(error_claims(results, light));
  }
  text +=
      "\n### What evenly spread points gain\n\nThe error with 256 independent points over that with Sobol "
      "points, geometric mean over the BRDFs.\n\n";
  return text + points_table(results);
}

std::string costs(const Results& results) {
  return "\n## What a scheme costs\n\nMeans over the BRDFs. To build is to make the tables and to find out "
         "what the scheme misses. The time of a sample is that of one thread, for the scheme alone, with its "
         "density, and with the BRDF's value as well; `own` has its weight in closed form, so the two are "
         "one. Anisotropic BRDFs have trees for up to 16 azimuths here, and `reject` keeps its "
         "tables.\n\n" +
         scheme_table(results) + "\nThe same for each BRDF: ns of a sample with its density.\n\n" +
         sample_table(results);
}

std::string target_table(const Results& results) {
  Table table({"target", "", "figures"});
  for (const Verdict& one : targets(results)) {
    table.add({one.claim, one.holds ? "holds" : "**does not hold**", one.figures});
  }
  return "\n## Targets\n\n" + table.str() + "\n" + limits(results);
}

}  // namespace

bool write_report(const Results& results, const std::string& folder, grf::Diagnostics& diagnostics) {
  const std::string readme = introduction(results) + thesis_tables(results) + costs(results) +
                             errors(results) + target_table(results);
  return grf::replace_file(folder + "/README.md", readme, diagnostics) &&
         grf::replace_file(folder + "/sampling.csv", errors_csv(results), diagnostics) &&
         grf::replace_file(folder + "/tables.csv", tables_csv(results), diagnostics) &&
         plot::write_picture(scheme_chart(results), folder + "/schemes.svg", diagnostics) &&
         plot::write_picture(convergence_chart(results), folder + "/convergence.svg", diagnostics);
}

}  // namespace study
