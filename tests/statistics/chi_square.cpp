#include "tests/statistics/chi_square.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <boost/math/distributions/chi_squared.hpp>

namespace statistics {
namespace {

constexpr double Tau = 2 * std::numbers::pi;
/// Pools cells with fewer expected samples, for which the statistic is not chi-square distributed.
constexpr double FewestExpected = 5;

struct Pool {
  double expected = 0;
  double counted = 0;
};

}  // namespace

ChiSquareTest::ChiSquareTest(const Quadrature::Function& pdf, const Vec3f& peak, int depth) {
  // Errors along a step have random signs, so larger ones per cell average out.
  const Quadrature quadrature(pdf, peak, depth > 0 ? 1e-7 : 1e-9, depth);
  for (int row = 0; row < Rows; ++row) {
    for (int column = 0; column < Columns; ++column) {
      probabilities_.push_back(quadrature.over({double(row) / Rows, double(row + 1) / Rows,
                                                Tau * column / Columns, Tau * (column + 1) / Columns}));
    }
  }
  probabilities_.push_back(std::max(0.0, 1 - mass()));
}

double ChiSquareTest::mass() const {
  return std::accumulate(probabilities_.begin(), probabilities_.begin() + Rows * Columns, 0.0);
}

double ChiSquareTest::p_value(const Sampler& sampler, int samples) const {
  std::vector<double> expectation = probabilities_;
  for (double& cell : expectation) cell *= samples;
  std::vector<double> counts(expectation.size(), 0.0);
  for (int i = 0; i < samples; ++i) {
    const std::optional<Vec3f> v = sampler();
    std::size_t cell = counts.size() - 1;
    if (v) {
      const double phi = std::atan2(v->y, v->x) + (v->y < 0 ? Tau : 0);
      const auto row = static_cast<std::size_t>(std::clamp(static_cast<int>(v->z * Rows), 0, Rows - 1));
      const auto column =
          static_cast<std::size_t>(std::clamp(static_cast<int>(phi / Tau * Columns), 0, Columns - 1));
      cell = row * Columns + column;
    }
    counts[cell] += 1;
  }
  return chi_square_p_value(expectation, counts);
}

double chi_square_p_value(const std::vector<double>& expectation, const std::vector<double>& counts) {
  double statistic = 0;
  int terms = 0;
  Pool pool;
  const auto add = [&](double expectation_of_cell, double count) {
    statistic += (count - expectation_of_cell) * (count - expectation_of_cell) / expectation_of_cell;
    ++terms;
  };
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (expectation[i] >= FewestExpected) {
      add(expectation[i], counts[i]);
    } else {
      pool.expected += expectation[i];
      pool.counted += counts[i];
    }
  }
  // Samples where the pdf is almost 0 are a failure, however few cells that is.
  if (pool.expected > FewestExpected / 5)
    add(pool.expected, pool.counted);
  else if (pool.counted > 20)
    return 0;
  if (terms < 2) return 1;
  return boost::math::cdf(boost::math::complement(boost::math::chi_squared(terms - 1), statistic));
}

double significance(int tests) { return 1 - std::pow(1 - 0.01, 1.0 / tests); }

}  // namespace statistics
