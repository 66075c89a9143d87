#pragma once

#include <string>

#include "grf/diagnostics.h"
#include "samples/studies/thesis/printed.h"
#include "samples/studies/thesis/results.h"

namespace study {

/// Writes README.md, rows.csv and the charts into the folder; false after an error.
bool write_report(const Results& results, const PrintedTables& printed, const std::string& folder,
                  grf::Diagnostics& diagnostics);

}  // namespace study
