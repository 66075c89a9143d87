// Writing of the study's report.
#pragma once

#include <string>

#include "grf/diagnostics.h"
#include "samples/studies/sampling/measure.h"

namespace study {

/// Writes README.md, sampling.csv (errors), tables.csv (all else) and the pictures.
bool write_report(const Results& results, const std::string& folder, grf::Diagnostics& diagnostics);

}  // namespace study
