// The tables of the report, as Markdown and as CSV.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "samples/studies/markdown.h"
#include "samples/studies/sampling/measure.h"

namespace study {

std::string build_table(const Results& results);   ///< 5.1
std::string tree_table(const Results& results);    ///< 5.2
std::string memory_table(const Results& results);  ///< 5.3
std::string factor_table(const Results& results);  ///< 5.6
std::string scheme_table(const Results& results);  ///< costs and fit, over all BRDFs
std::string sample_table(const Results& results);  ///< time per sample and BRDF
std::string choice_table(const Results& results);  ///< results of the parameter search
std::string error_table(const Results& results, Light light, Points points);  ///< 256 Sobol points
std::string points_table(const Results& results);                             ///< Sobol against independent

/// Formats one row per BRDF, scheme, view and kind of points.
std::string errors_csv(const Results& results);
/// Formats one row per quantity of a BRDF and scheme other than errors.
std::string tables_csv(const Results& results);

/// Returns the geometric mean.
template <class Items, class ValueOf>
double geometric_mean(const Items& items, const ValueOf& value_of) {
  double sum = 0;
  for (const auto& item : items) sum += std::log(value_of(item));
  return std::exp(sum / static_cast<double>(items.size()));
}

constexpr std::size_t MostSamples = SampleCounts.size() - 1;

inline double kilobytes(std::size_t bytes) { return static_cast<double>(bytes) / 1024; }

}  // namespace study
