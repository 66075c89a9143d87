#include "renderer/command/brdf_fit_options.h"

#include <CLI/CLI.hpp>

namespace command {

void add_fit(CLI::App& brdf, BrdfFitArguments& arguments) {
  CLI::App& fit = *brdf.add_subcommand("fit", "Fit BRDF models to measured data or to another BRDF");
  fit.add_option("DATA", arguments.data,
                 "a CSV file (its first line names the columns: theta_u,phi_u,theta_v,phi_v,r,g,b), a MERL "
                 "(.binary) or RGL (.bsdf) file, or any BRDF as for the other commands")
      ->required();
  fit.add_option("--to", arguments.targets, "models to fit, and sums of them, \"ward,ggx,combine ggx eon\"")
      ->type_name("MODEL,...")
      ->required();
  fit.add_option("--lobes", arguments.lobes, "fit sums of this many lobes of each model (1)")
      ->type_name("N")
      ->check(CLI::Range(1, 4));
  fit.add_option(
         "--metric", arguments.metric,
         "what is least: differences of cube roots of f cos, of log(1 + f cos), or of f cos (cuberoot)")
      ->check(CLI::IsMember({"cuberoot", "log", "l2"}));
  fit.add_option("--fix", arguments.fixed, "keep a parameter at a value; may be repeated")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  fit.add_option("--samples", arguments.samples,
                 "pairs of directions of a BRDF (4000), or cells of a MERL table (20000)")
      ->type_name("N")
      ->check(CLI::Range(1, 10'000'000));
  fit.add_option("-o,--output", arguments.output,
                 "file for the best fit; a sum is the definition 'fit' in it, read as FILE:fit")
      ->type_name("FILE");
  fit.add_option("--report", arguments.report, "folder for a report in Markdown and HTML with charts")
      ->type_name("DIR");
  fit.add_option("--threads", arguments.threads, "number of threads (0: one per core)")
      ->type_name("T")
      ->check(CLI::Range(0, 4096));
  fit.add_flag("--json", arguments.json, "print one JSON object");
}

}  // namespace command
