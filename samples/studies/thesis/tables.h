// The thesis' tables are printed with today's figures beside them.
#pragma once

#include <string>
#include <string_view>

#include "samples/studies/thesis/printed.h"
#include "samples/studies/thesis/results.h"

namespace study {

/// Returns whether a BRDF of table 5.5, or of a material, is glossy. Images with several BRDFs count as
/// glossy.
bool is_glossy(std::string_view brdf);

/// The content of a table over sample counts.
struct Content {
  std::string scene;
  Quantity quantity;
  std::vector<std::string_view> more;  ///< our techniques, besides the thesis'
};

/// Writes a row of the thesis and today's rows per technique, as means over the BRDFs.
std::string sweep_table(const PrintedTable& printed, const Content& content, const Results& results);

// Tables 5.19 and 5.20: a row per material, and columns in pairs.
std::string precomputation_table(const PrintedTable& printed, const Results& results);
std::string material_times_table(const PrintedTable& printed, const Results& results);

/// Lists the misprints of a table.
std::string notes(const PrintedTable& printed);

}  // namespace study
