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
  Eigen::VectorXd squares(rows);
  for (Eigen::Index row = 0; row < rows; ++row) {
    const double leverage = std::min(left.row(row).squaredNorm(), 1 - 1e-6);
    squares(row) = residuals(row) * residuals(row) / (1 - leverage);
  }
  const Eigen::MatrixXd middle = left.transpose() * squares.asDiagonal() * left;
  const Eigen::MatrixXd covariance = to_unknowns * middle * to_unknowns.transpose();
  const boost::math::students_t distribution(static_cast<double>(rows - rank));
  const double quantile = boost::math::quantile(distribution, 0.975);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto place = static_cast<std::size_t>(i);
    all[free.unknowns[place]].half_width =
        quantile * std::sqrt(std::max(0.0, covariance(i, i))) / free.lengths[place];
  }
  return all;
}

}  // namespace fit
