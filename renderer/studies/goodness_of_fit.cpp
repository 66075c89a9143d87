#include "renderer/studies/goodness_of_fit.h"

#include <algorithm>

#include <boost/math/special_functions/gamma.hpp>

namespace studies {

GoodnessOfFit goodness_of_fit(std::span<const double> expected, std::span<const double> counted) {
  // Fewer expected samples than this, even in all small cells together, are no term of the statistic.
  constexpr double TooFew = FewestExpected / 5;
  constexpr double Unexpected = 20;
  GoodnessOfFit fit;
  const auto add = [&](double expectation, double count) {
    fit.statistic += (count - expectation) * (count - expectation) / expectation;
    ++fit.degrees;
  };
  double pooled = 0;
  double pooled_count = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (expected[i] >= FewestExpected) {
      add(expected[i], counted[i]);
    } else {
      pooled += expected[i];
      pooled_count += counted[i];
    }
  }
  if (pooled > TooFew) add(pooled, pooled_count);
  fit.degrees = std::max(0, fit.degrees - 1);
  if (fit.degrees > 0) fit.p_value = boost::math::gamma_q(fit.degrees / 2.0, fit.statistic / 2);
  if (pooled <= TooFew && pooled_count > Unexpected) fit.p_value = 0;
  return fit;
}

}  // namespace studies
