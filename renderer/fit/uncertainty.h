#pragma once

#include <span>
#include <vector>

#include "renderer/fit/problem.h"

namespace fit {

/// How well the observations determine an unknown at the solution of a fit.
struct Uncertainty {
  /// Half of the unknown's interval of 95 % confidence; 0 at a bound, where there is none.
  double half_width = 0;
  bool is_at_bound = false;
  /// False if residuals hardly change with the unknown, or with it and others together: their column of the
  /// Jacobian is in a singular vector below 1e-4 of the largest, columns scaled to equal length.
  bool is_determined = true;
};

/// Computes the uncertainties of all unknowns from the Jacobian and the residuals at the solution. The
/// covariance is the sandwich of MacKinnon and White (1985, "HC3"), which holds where the noise differs
/// between observations, as it does in any metric, and for noise that an observation's channels share; those
/// of directions that are not determined are left out.
std::vector<Uncertainty> uncertainties(const Problem& problem, std::span<const double> x);

}  // namespace fit
