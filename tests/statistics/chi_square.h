#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "tests/statistics/quadrature.h"

namespace statistics {

/// A chi-square goodness-of-fit test of samples against a pdf, on a grid over the hemisphere. Empty samples
/// fall into one more cell, whose probability is 1 minus the pdf's integral.
class ChiSquareTest {
 public:
  using Sampler = std::function<std::optional<Vec3f>()>;

  /// Takes the minimal depth of the quadrature: above 0 for a pdf with steps.
  ChiSquareTest(const Quadrature::Function& pdf, const Vec3f& peak, int depth = 0);

  double p_value(const Sampler& sampler, int samples) const;

  /// Returns the pdf's integral over the hemisphere.
  double mass() const;

 private:
  static constexpr int Rows = 12;
  static constexpr int Columns = 24;

  std::vector<double> probabilities_;  ///< of the cells, and last of empty samples
};

/// Returns the p-value: the probability of counts at least this far off expectations of the same sum. Cells
/// of small expectation are pooled.
double chi_square_p_value(const std::vector<double>& expectation, const std::vector<double>& counts);

/// Returns the significance level for each of `tests` tests so that together they raise a false alarm in 1 %
/// of runs (Sidak's correction).
double significance(int tests);

}  // namespace statistics
