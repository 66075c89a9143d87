#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grf/diagnostics.h"
#include "renderer/fit/fit.h"

namespace command {

/// Data and the models that were fitted to them.
struct BrdfFits {
  std::string data;  ///< as named on the command line
  fit::Observations observations;
  std::optional<reflectance::Brdf> brdf;  ///< the data as a BRDF; nothing for a CSV file
  fit::Metric metric = fit::Metric::CubeRoot;
  std::vector<fit::Fit> fits;  ///< the best one in the metric first
};

/// Returns a parameter's name with its channel, and in a sum with its term: `1 ks red`.
std::string name_of(const fit::FittedParameter& parameter, const fit::Fit& fit);

/// Returns the interval of a parameter in words, or why it has none.
std::string interval_of(const fit::FittedParameter& parameter);

/// Writes a report to a folder, which is made: report.md and report.html, with the ranking of the fits by
/// each metric, their GRF texts and parameters; and per fit its lobes in the plane of incidence with those of
/// the data, and the residuals over the angles of the half vector, as SVG. Returns false after an error.
bool write_fit_report(const BrdfFits& fits, const std::string& folder, grf::Diagnostics& diagnostics);

}  // namespace command
