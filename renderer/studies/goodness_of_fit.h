#pragma once

#include <span>

namespace studies {

/// Cells with fewer expected samples are pooled, as the statistic of each is not chi-square distributed.
constexpr double FewestExpected = 5;

/// Pearson's chi-square test of counts against their expectations.
struct GoodnessOfFit {
  double statistic = 0;
  int degrees = 0;     ///< of freedom
  double p_value = 1;  ///< the probability of a statistic at least as large
};

/// Tests counts whose expectations have the same sum. Cells of small expectation are pooled; counts where
/// next to nothing is expected have a p-value of 0.
GoodnessOfFit goodness_of_fit(std::span<const double> expected, std::span<const double> counted);

}  // namespace studies
