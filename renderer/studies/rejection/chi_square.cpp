#include "renderer/studies/rejection/chi_square.h"

#include <numeric>

#include <boost/math/distributions/chi_squared.hpp>

namespace studies {

std::optional<double> chi_square_p_value(const std::vector<double>& probabilities,
                                         const std::vector<double>& counts) {
  constexpr double FewestExpected = 5;
  struct Class {
    double expected = 0;
    double counted = 0;
  };
  const double total = std::accumulate(counts.begin(), counts.end(), 0.0);
  std::vector<Class> classes;
  Class pool;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    pool.expected += probabilities[i] * total;
    pool.counted += counts[i];
    if (pool.expected < FewestExpected) continue;
    classes.push_back(pool);
    pool = {};
  }
  if (classes.size() < 2) return std::nullopt;
  // What is left over is too little for a class of its own.
  classes.back().expected += pool.expected;
  classes.back().counted += pool.counted;
  double statistic = 0;
  for (const Class& one : classes) {
    const double difference = one.counted - one.expected;
    statistic += difference * difference / one.expected;
  }
  const boost::math::chi_squared distribution(static_cast<double>(classes.size() - 1));
  return boost::math::cdf(boost::math::complement(distribution, statistic));
}

}  // namespace studies
