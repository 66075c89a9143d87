#include "renderer/fit/solver.h"

#include <algorithm>

#include <boost/random/sobol.hpp>
#include <ceres/cost_function.h>
#include <ceres/problem.h>
#include <ceres/solver.h>

#include "renderer/parallel/loops.h"

namespace fit {
namespace {

/// All residuals as a function of one block of all unknowns.
class AllResiduals : public ceres::CostFunction {
 public:
  explicit AllResiduals(const Problem& problem) : problem_(problem) {
    set_num_residuals(static_cast<int>(problem.residual_count()));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(problem.unknown_count()));
  }

  bool Evaluate(const double* const* x, double* residuals, double** jacobians) const override {
    const std::size_t rows = problem_.residual_count();
    const std::size_t columns = problem_.unknown_count();
    const bool has_jacobian = jacobians != nullptr && jacobians[0] != nullptr;
    return problem_.evaluate(
        {x[0], columns}, {residuals, rows},
        has_jacobian ? std::span<double>(jacobians[0], rows * columns) : std::span<double>());
  }

 private:
  const Problem& problem_;
};

}  // namespace

std::vector<Candidate> scan(const Problem& problem, std::size_t points, std::size_t kept) {
  const std::size_t shapes = problem.shape_count();
  if (shapes == 0) points = 1;
  std::vector<Candidate> candidates(points);
  std::vector<char> was_taken(points, 0);
  boost::random::sobol sequence(std::max<std::size_t>(1, shapes));
  for (Candidate& candidate : candidates) {
    candidate.x.assign(problem.unknown_count(), 0);
    for (std::size_t i = 0; i < shapes; ++i)
      candidate.x[i] = problem.scanned(i, static_cast<double>(sequence()) / 0x1p64);
  }
  parallel::for_each_index(points, [&](std::size_t i) {
    Candidate& candidate = candidates[i];
    if (!problem.solve_weights(candidate.x)) return;
    const auto cost = problem.cost(candidate.x);
    if (!cost) return;
    candidate.cost = *cost;
    was_taken[i] = 1;
  });
  std::vector<Candidate> taken;
  for (std::size_t i = 0; i < points; ++i) {
    if (was_taken[i] != 0) taken.push_back(std::move(candidates[i]));
  }
  std::stable_sort(taken.begin(), taken.end(),
                   [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
  taken.resize(std::min(taken.size(), kept));
  return taken;
}

Candidate refine(const Problem& problem, const Candidate& start, int iterations) {
  Candidate candidate = start;
  ceres::Problem all;
  all.AddResidualBlock(new AllResiduals(problem), nullptr, candidate.x.data());
  for (std::size_t i = 0; i < candidate.x.size(); ++i) {
    all.SetParameterLowerBound(candidate.x.data(), static_cast<int>(i), 0);
    all.SetParameterUpperBound(candidate.x.data(), static_cast<int>(i), problem.upper(i));
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = iterations;
  // Shapes are floats, so that no step below their last digit means anything.
  options.function_tolerance = 1e-14;
  options.parameter_tolerance = 1e-9;
  options.gradient_tolerance = 1e-30;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &all, &summary);
  const auto cost = problem.cost(candidate.x);
  if (!summary.IsSolutionUsable() || !cost || *cost > start.cost) return start;
  candidate.cost = *cost;
  return candidate;
}

}  // namespace fit
