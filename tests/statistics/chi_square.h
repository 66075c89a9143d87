#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "tests/statistics/quadrature.h"

namespace statistics {

/// Counts samples on a grid over the hemisphere and compares with what a density says: the probability of
/// counts at least this far off, if the density is right. Samples that are empty fall into one more cell,
/// whose probability is what the density leaves of 1.
class ChiSquareTest {
 public:
  using Sampler = std::function<std::optional<Vec3f>()>;

  /// `depth` is the quadrature's: over 0 for a density with steps.
  ChiSquareTest(const Quadrature::Function& density, const Vec3f& peak, int depth = 0);

  double p_value(const Sampler& sampler, int samples) const;

  /// The density's integral over the hemisphere.
  double mass() const;

 private:
  static constexpr int Rows = 12;
  static constexpr int Columns = 24;

  std::vector<double> probabilities_;  ///< of the cells, and last of no sample
};

/// The significance to ask of each of `tests` tests so that all together raise a false alarm in 1 % of runs
/// (Sidak's correction).
double significance(int tests);

}  // namespace statistics
