// The thesis' tables with today's figures in them.
#pragma once

#include <string>
#include <string_view>

#include "samples/studies/thesis/printed.h"
#include "samples/studies/thesis/results.h"

namespace study {

/// Whether a BRDF of table 5.5, or a material's, has a lobe. Images with several BRDFs count as glossy.
bool is_glossy(std::string_view brdf);

/// What a table of numbers of samples is about.
struct Content {
  std::string scene;
  Quantity quantity;
  std::vector<std::string_view> more;  ///< techniques of ours besides the thesis'
};

/// A row of the thesis and those of today for each technique; the means over the BRDFs.
std::string sweep_table(const PrintedTable& printed, const Content& content, const Results& results);

/// Tables 5.19 and 5.20: a row for each material, and columns in pairs.
std::string precomputation_table(const PrintedTable& printed, const Results& results);
std::string material_times_table(const PrintedTable& printed, const Results& results);

/// What is wrong in print.
std::string notes(const PrintedTable& printed);

}  // namespace study
