// The figures of all distributions share the header, the numbers, and the histogram.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/plot/chart.h"
#include "renderer/studies/rejection/run.h"

namespace studies {

namespace rejection_colours {
// For the colour-blind, as `plot::colour_of_series`.
constexpr std::string_view Accepted = "#0072b2";
constexpr std::string_view Rejected = "#e69f00";
constexpr std::string_view Bound = "#cc79a7";
constexpr std::string_view Tree = "#009e73";
constexpr std::string_view Function = "#222";
constexpr std::string_view Bar = "#5f9ecb";
constexpr std::string_view Lost = "#f2b0a5";
constexpr std::string_view Warning = "#cc0000";
}  // namespace rejection_colours

/// A p-value below this is shown as a failure.
constexpr double LeastPValue = 0.01;

/// Numbers of rejection under one bound, or of a subdivision.
struct MethodNumbers {
  std::string bound;
  double expected = 0;  ///< fractions of tries that are accepted
  double acceptance = 0;
  double tries_per_sample = 0;
  double nanoseconds_per_sample = 0;
  std::optional<double> p_value = {};  ///< of a chi-square test; nothing with too few samples
};

template <class Place>
MethodNumbers numbers_of(const Run<Place>& run, double expected, std::string bound) {
  const auto count = static_cast<double>(run.accepted.size());
  if (run.accepted.empty()) return {std::move(bound), expected};
  return {std::move(bound), expected, run.acceptance(), static_cast<double>(run.tries) / count,
          1e9 * run.seconds / count};
}

/// A histogram of accepted samples with the distribution that they should have, over equal bins.
struct Histogram {
  std::string x_label;
  std::string y_label;
  double low = 0;
  double high = 1;
  std::vector<double> densities;  ///< of the accepted samples, a bin each
  std::vector<plot::Point> expected;
  std::vector<plot::Point> sampled;  ///< what a bound that is too low samples; empty if it is high enough
};

/// What is reported beside the panels of tries.
struct RejectionReport {
  std::string title;
  std::string note;
  std::string subdivision;  ///< what its column is called
  MethodNumbers single;
  std::optional<MethodNumbers> tree;
  std::string no_tree_reason;
  std::vector<std::string> remarks;
  std::vector<std::string> warnings;
  Histogram histogram;
};

/// Adds warnings about a run that was not completed, or whose bound was exceeded.
template <class Place>
void add_warnings(const Run<Place>& run, std::size_t wanted, std::vector<std::string>& warnings);
void add_warnings(std::size_t tries, std::size_t accepted, std::size_t above, std::size_t wanted,
                  std::vector<std::string>& warnings);
template <class Place>
void add_warnings(const Run<Place>& run, std::size_t wanted, std::vector<std::string>& warnings) {
  add_warnings(run.tries, run.accepted.size(), run.above, wanted, warnings);
}

/// Compares the grid's maximum with the exact one, in words.
std::string compared_maxima(double exact, double grid, std::string_view grid_name);

/// The size of the figure, and the place of the panels of tries.
constexpr double RejectionWidth = 1040;
constexpr double RejectionHeight = 620;

struct LegendItem {
  std::string_view colour;
  std::string_view words;
  bool is_line = false;
};

/// Draws all but the panels of tries.
void draw_report(const RejectionReport& report, const std::vector<LegendItem>& legend, plot::Svg& svg);

/// Returns dots of the tries that were accepted, or of those that were rejected.
plot::Series dots_of(std::vector<plot::Point> points, std::string_view colour);

/// Fills what of a curve is above a bound.
plot::Series lost_above(const std::vector<plot::Point>& curve, double bound);

/// Returns a result in a sentence.
std::string summary_of(const RejectionReport& report, std::size_t tries, std::size_t accepted);

/// Formats a p-value.
std::string p_value_text(double p_value);

}  // namespace studies
