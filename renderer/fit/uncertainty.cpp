#include "renderer/fit/uncertainty.h"

#include <algorithm>
#include <cmath>

#include <Eigen/QR>
#include <Eigen/SVD>
#include <boost/math/distributions/students_t.hpp>

namespace fit {
namespace {

constexpr double SmallestSingularValue = 1e-4;
constexpr double SmallestPart = 0.05;  ///< of a singular vector that counts as containing an unknown

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The unknowns that are free at the solution, and the columns of their Jacobian.
struct FreeColumns {
  std::vector<std::size_t> unknowns;
  Eigen::MatrixXd columns;  ///< of length 1
  std::vector<double> lengths;
};

FreeColumns free_columns(const Problem& problem, std::span<const double> x, const Matrix& jacobian,
                         std::vector<Uncertainty>& all) {
  constexpr double AtBound = 1e-7;
  FreeColumns free;
  const double longest = jacobian.colwise().norm().maxCoeff();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double length = jacobian.col(static_cast<Eigen::Index>(i)).norm();
    all[i].is_determined = length > 1e-9 * longest;
    all[i].is_at_bound = x[i] < AtBound || x[i] > problem.upper(i) * (1 - AtBound);
    if (!all[i].is_determined || all[i].is_at_bound) continue;
    free.unknowns.push_back(i);
    free.lengths.push_back(length);
  }
  free.columns.resize(jacobian.rows(), static_cast<Eigen::Index>(free.unknowns.size()));
  for (std::size_t i = 0; i < free.unknowns.size(); ++i) {
    free.columns.col(static_cast<Eigen::Index>(i)) =
        jacobian.col(static_cast<Eigen::Index>(free.unknowns[i])) / free.lengths[i];
  }
  return free;
}

/// Returns what the residuals of each observation change in the directions of `left`, with the correction HC3
/// of MacKinnon and White (1985) for leverage. The channels of an observation are added: what is wrong with a
/// measurement is wrong with all of them (the clusters of Liang and Zeger 1986).
Eigen::MatrixXd changes_by(const Eigen::MatrixXd& left, const Eigen::VectorXd& residuals,
                           Eigen::Index channels) {
  Eigen::MatrixXd changes = Eigen::MatrixXd::Zero(left.rows() / channels, left.cols());
  for (Eigen::Index row = 0; row < left.rows(); ++row) {
    const double leverage = std::min(left.row(row).squaredNorm(), 1 - 1e-6);
    changes.row(row / channels) += residuals(row) / (1 - leverage) * left.row(row);
  }
  return changes;
}

/// Returns half of the interval of 95 % confidence of an unknown that observations change by so much. Where
/// few of them matter, the variance is itself uncertain: Satterthwaite's degrees of freedom (1946), as Bell
/// and McCaffrey (2002) use them, with E(x^4) = 3 E(x^2)^2 of normal noise.
double half_width_of(const Eigen::VectorXd& changes, double freedom) {
  const double variance = changes.squaredNorm();
  if (variance <= 0) return 0;
  const double effective = 3 * variance * variance / changes.array().square().matrix().squaredNorm();
  const boost::math::students_t distribution(std::max(1.0, std::min(effective, freedom)));
  return boost::math::quantile(distribution, 0.975) * std::sqrt(variance);
}

}  // namespace

std::vector<Uncertainty> uncertainties(const Problem& problem, std::span<const double> x) {
  std::vector<Uncertainty> all(problem.unknown_count());
  const auto rows = static_cast<Eigen::Index>(problem.residual_count());
  Matrix jacobian(rows, static_cast<Eigen::Index>(all.size()));
  Eigen::VectorXd residuals(rows);
  const bool was_taken = problem.evaluate(x, {residuals.data(), static_cast<std::size_t>(rows)},
                                          {jacobian.data(), static_cast<std::size_t>(jacobian.size())});
  const auto undetermine = [&] {
    for (Uncertainty& one : all) one.is_determined = false;
    return all;
  };
  if (!was_taken || !jacobian.allFinite()) return undetermine();
  const FreeColumns free = free_columns(problem, x, jacobian, all);
  const Eigen::Index count = free.columns.cols();
  if (count == 0) return all;
  if (rows <= count) return undetermine();
  // The singular values of the triangular factor are those of the columns.
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(free.columns);
  const Eigen::MatrixXd triangle =
      qr.matrixQR().topRows(count).template triangularView<Eigen::Upper>().toDenseMatrix();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(triangle, Eigen::ComputeFullV);
  const Eigen::VectorXd& values = svd.singularValues();
  Eigen::Index rank = 0;
  while (rank < count && values(rank) > SmallestSingularValue * values(0)) ++rank;
  for (Eigen::Index j = rank; j < count; ++j) {
    for (Eigen::Index i = 0; i < count; ++i) {
      if (std::abs(svd.matrixV()(i, j)) < SmallestPart) continue;
      all[free.unknowns[static_cast<std::size_t>(i)]].is_determined = false;
    }
  }
  const Eigen::MatrixXd to_unknowns =
      svd.matrixV().leftCols(rank) * values.head(rank).cwiseInverse().asDiagonal();
  const Eigen::MatrixXd left = free.columns * to_unknowns;  // orthonormal columns
  const Eigen::MatrixXd changes = changes_by(left, residuals, problem.channels()) * to_unknowns.transpose();
  const auto freedom = static_cast<double>(rows - rank) / problem.channels();
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto place = static_cast<std::size_t>(i);
    all[free.unknowns[place]].half_width = half_width_of(changes.col(i), freedom) / free.lengths[place];
  }
  return all;
}

}  // namespace fit
