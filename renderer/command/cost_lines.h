// What a study of cost compares: its command line taken apart.
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

/// Something that a line of the chart may have of its own: the flag of a list of values.
struct SweepAxis {
  std::string_view flag;
  std::string_view values;  ///< what the list is of
  std::string_view meaning;
};

/// The axes besides samples.
const std::vector<SweepAxis>& sweep_axes();

/// Lists by their flags, as they were given.
using Sweeps = std::map<std::string, std::string>;

/// What is the same in all renders of one line; only samples and seeds differ.
struct CostLine {
  std::string name;  ///< what tells it from the others, such as `Disk, depth 2`
  std::string pdf;   ///< the scheme as it was asked for; `scene` where each BRDF has its own
  options::RenderOptions options;
  std::optional<grf::PdfModel> scheme;  ///< checked; nothing where each BRDF has its own
};

/// The words of a list, divided by commas that are not in parentheses.
std::vector<std::string> split_list(const std::string& text);

/// One line for each combination of values. An axis that belongs to a scheme (`--trees`) divides the lines of
/// that scheme alone; without `--pdf` it is of all of them. Prints what is wrong with the lists, and returns
/// nothing then.
std::optional<std::vector<CostLine>> cost_lines(const Sweeps& sweeps,
                                                const options::RenderOptions& render_options);

/// Whole numbers, each over 0 and over the one before. Prints what is wrong.
std::optional<std::vector<int>> sample_counts(const std::string& list);

}  // namespace command
