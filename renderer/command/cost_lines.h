// The lines of a cost study are the combinations of settings that `bpt cost` compares.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grf/diagnostics.h"
#include "grf/model.h"
#include "renderer/options/render_options.h"

namespace command {

/// A setting that may differ between lines of the chart: a flag that takes a list of values.
struct SweepAxis {
  std::string_view flag;
  std::string_view values;  ///< placeholder of the list in `--help`
  std::string_view meaning;
};

/// Returns the axes of a sweep besides samples.
const std::vector<SweepAxis>& sweep_axes();

/// Lists of values by flag, as on the command line.
using Sweeps = std::map<std::string, std::string>;

/// The settings that all renders of one line share; only samples and seeds differ.
struct CostLine {
  std::string name;  ///< distinguishes the line from the others, such as `Disk, depth 2`
  std::string pdf;   ///< the scheme as on the command line; `scene` where each BRDF has its own
  options::RenderOptions options;
  std::optional<grf::PdfModel> scheme;  ///< checked; nothing where each BRDF has its own
};

/// Returns the settings of a line as text, which is the same for lines that render the same.
std::string key_of(const CostLine& line);

/// Returns the OP lines that give a render the settings of a line; empty if its scheme has
/// parameters that only a PDF of a scene can have.
std::vector<std::string> op_lines_of(const CostLine& line);

/// Splits a list at commas outside parentheses.
std::vector<std::string> split_list(const std::string& text);

/// Returns one line per combination of values. An axis that belongs to a scheme (`--trees`) splits only the
/// lines of that scheme; without `--pdf` it implies the scheme. Prints errors in the lists and then returns
/// nothing.
std::optional<std::vector<CostLine>> cost_lines(const Sweeps& sweeps,
                                                const options::RenderOptions& render_options);

/// Parses whole numbers over 0 in ascending order. Prints errors and then returns nothing.
std::optional<std::vector<int>> sample_counts(const std::string& list);

}  // namespace command
