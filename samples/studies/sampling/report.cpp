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
  return fmt::format(R"(# Cost and error of sampling schemes

`{}` generated this file, `sampling.csv` (every error), `tables.csv` (every other figure) and the
pictures, on a machine with {}. Times are the minimum of some runs
(of one, if that takes over five seconds), and other load on the machine lengthens them. Errors depend only on the points.{}

The BRDFs are those of table 5.5 of Montes' thesis (2008). A BRDF is called glossy, and has a star in the tables of errors, if
its model has a lobe. The deviation is the relative error of one sample under a constant environment. Exponents of lobes are 50 or, "best", those of least deviation; `factored` has the parameters that fit
best (below); the other schemes have their defaults.{}

{})",
                     results.command, results.machine,
                     results.effort.is_quick
                         ? fmt::format(" This is the quick run: few repeats, {} cells along the edge of the "
                                       "grid of `reject` instead of 800, and a short search.",
                                       results.effort.resolution)
                         : "",
                     results.cases.size() == cases().size()
                         ? ""
                         : " This run has only some of them, and judges the claims by these.",
                     choice_table(results));
}

std::string thesis_tables(const Results& results) {
  std::string text = "\n## Time to build (table 5.1)\n\nSeconds for 60 and 90 trees with one azimuth. ";
  text +=
      "Factors have the parameters of table 5.6, and those found below; for isotropic BRDFs u needs no "
      "azimuth, for which the thesis had 16.\n\n";
  text += build_table(results) + sentences(build_claims(results));
  text +=
      "\n## Memory of one tree against n_max (table 5.2)\n\nKB for `mode=reject` and a view at 45 degrees, "
      "without the table of values. The thesis does not name its view.\n\n";
  text += tree_table(results) + sentences(tree_claims(results));
  text +=
      "\n## Memory of the trees and of the factors (table 5.3)\n\nKB; `reject` is without its tables, as in "
      "the thesis (`release=true`).\n\n";
  text += memory_table(results) + sentences(memory_claims(results));
  text +=
      "\n## Parameters of the factors (table 5.6)\n\nThe distance is the total variation distance of the pdf "
      "from f cos / albedo (half the integral of the absolute difference), averaged over views at 20, 45 and "
      "70 degrees. Found: the least distance of all J and K up to ";
  text += fmt::format(
      "{}, directions and half vectors, and 32x16, 100x32 and 200x32 cells; of those within 2 % of it, the "
      "one with the smallest tables.\n\n",
      results.effort.most_factors);
  return text + factor_table(results) + sentences(factor_claims(results));
}

std::string errors(const Results& results) {
  std::string text = fmt::format(
      "\n## Error at equal samples\n\nThe relative error of reflected radiance, root mean square over {} "
      "estimates of 256 points each and over views at 20, 45 and 70 degrees. The lights are a small light "
      "anywhere on the hemisphere, with the errors of all its positions summed as in a picture of a sphere "
      "(anywhere); a sky with a hazy sun and ground (environment); and discs of 5 degrees in radius at the "
      "mirror direction (highlight) and 30 degrees from it (beside). Errors are relative to at least a "
      "thousandth of what a white diffuse surface reflects. The least of the generic schemes is bold; `own` "
      "is the model's own sampler. A scheme whose pdf may be 0 where a BRDF reflects is mixed with cosine "
      "sampling, as in images. Points are a scrambled Sobol sequence, as in images, or independent, as in "
      "the thesis, whose claims are judged by these. A difference within twice its standard error counts as "
      "none.\n\n![Error of each scheme](schemes.svg)\n\n![Error over samples](convergence.svg)\n",
      results.effort.repeats);
  for (const Light light : LightsByWeight) {
    text += fmt::format("\n### {}\n\n", LightNames[light]) + error_table(results, light, Sobol) + "\n" +
            error_table(results, light, Independent);
    text += sentences(error_claims(results, light));
  }
  text +=
      "\n### Gain of low-discrepancy points\n\nThe error ratio of 256 independent points to Sobol points, "
      "geometric mean over the BRDFs.\n\n";
  return text + points_table(results);
}

std::string costs(const Results& results) {
  return "\n## Cost of a scheme\n\nMeans over the BRDFs. Building includes the tables and the estimate of "
         "what the scheme's pdf misses. The time of a sample is that of one thread, for a direction with its "
         "pdf, and with the BRDF's value too; `own` has its weight in closed form, so the two are the same. "
         "Anisotropic BRDFs have trees for up to 16 azimuths here, and `reject` keeps its tables.\n\n" +
         scheme_table(results) + "\nThe same per BRDF: ns of a sample with its pdf.\n\n" +
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
