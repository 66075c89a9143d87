#pragma once

#include <cstddef>
#include <vector>

#include "renderer/fit/problem.h"

namespace fit {

/// A point of the unknowns and its cost, half the sum of squared residuals.
struct Candidate {
  std::vector<double> x;
  double cost = 0;
};

/// Scans the shapes' coordinates by a Sobol sequence, solves the weights at each point, and returns the
/// `kept` points of the least cost, the best one first; fewer if a model does not take the others. Without
/// shapes there is one point.
std::vector<Candidate> scan(const Problem& problem, std::size_t points, std::size_t kept);

/// Refines a candidate by the method of Levenberg and Marquardt within the bounds, of Ceres: of Debian's
/// solvers it alone is made for least squares, where NLopt's have to do without the residuals' Jacobian.
Candidate refine(const Problem& problem, const Candidate& start, int iterations);

}  // namespace fit
