#include "renderer/reflectance/schemes/nonnegative_factors.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "renderer/parallel/loops.h"
#include "renderer/reflectance/halton.h"

namespace reflectance {
namespace {

/// The minimum of divisors, so that 0 / 0 is 0.
constexpr double Least = 1e-300;

/// Updates `right`, or `left` with the transposed matrix. Columns are independent of each other.
void update(const Eigen::MatrixXd& y, const Eigen::MatrixXd& left, Eigen::MatrixXd& right) {
  constexpr Eigen::Index Block = 16;  // columns at a time; fixed, since sums in blocks depend on their size
  const Eigen::VectorXd sums = left.rowwise().sum().cwiseMax(Least);
  parallel::for_each_index((y.cols() + Block - 1) / Block, [&](Eigen::Index block) {
    const Eigen::Index first = block * Block;
    const Eigen::Index count = std::min(Block, y.cols() - first);
    auto part = right.middleCols(first, count);
    const Eigen::MatrixXd product = left.transpose() * part;
    const Eigen::MatrixXd ratio = y.middleCols(first, count).cwiseQuotient(product.cwiseMax(Least));
    const Eigen::MatrixXd gain = left * ratio;
    part.array() *= gain.array().colwise() / sums.array();
  });
}

/// Initialises by distributing sums over the ranks unevenly, since equal ones stay equal under the updates.
Eigen::MatrixXd start(const Eigen::VectorXd& sums, Eigen::Index rank, std::uint32_t seed) {
  Eigen::MatrixXd matrix(rank, sums.size());
  for (Eigen::Index i = 0; i < sums.size(); ++i) {
    for (Eigen::Index k = 0; k < rank; ++k) {
      const auto point = halton_point(seed + static_cast<std::uint32_t>(i * rank + k) * 7);
      matrix(k, i) = sums(i) * (0.05 + (rank > 1 ? static_cast<double>(point.choice) : 0.95));
    }
  }
  return matrix;
}

}  // namespace

double divergence(const Eigen::MatrixXd& y, const NonnegativeFactors& factors) {
  double sum = 0;
  for (Eigen::Index column = 0; column < y.cols(); ++column) {
    const Eigen::VectorXd product = factors.left.transpose() * factors.right.col(column);
    for (Eigen::Index row = 0; row < y.rows(); ++row) {
      const double value = y(row, column);
      sum += product(row) - value;
      if (value > 0) sum += value * std::log(value / std::max(product(row), Least));
    }
  }
  return sum;
}

NonnegativeFactors factorised(const Eigen::MatrixXd& y, Eigen::Index rank) {
  constexpr int MostRounds = 50;
  constexpr int UpdatesPerRound = 10;
  constexpr double LeastGain = 1e-5;  // relative, per iteration
  const double whole = y.sum();
  if (!(whole > 0)) return {Eigen::MatrixXd::Zero(rank, y.rows()), Eigen::MatrixXd::Zero(rank, y.cols())};
  const Eigen::MatrixXd transposed = y.transpose();
  NonnegativeFactors factors = {start(y.rowwise().sum(), rank, 0), start(y.colwise().sum(), rank, 5)};
  double before = HUGE_VAL;
  for (int round = 0; round < MostRounds; ++round) {
    for (int i = 0; i < UpdatesPerRound; ++i) {
      update(y, factors.left, factors.right);
      update(transposed, factors.right, factors.left);
    }
    const double now = divergence(y, factors);
    if (!(before - now > LeastGain * whole)) break;
    before = now;
  }
  return factors;
}

}  // namespace reflectance
