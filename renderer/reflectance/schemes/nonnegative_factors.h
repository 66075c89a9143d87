#pragma once

#include <Eigen/Core>

namespace reflectance {

/// Two non-negative matrices whose product left^T right approximates a given one.
struct NonnegativeFactors {
  Eigen::MatrixXd left;   ///< rank x rows of the given one
  Eigen::MatrixXd right;  ///< rank x columns
};

/// Factorises a matrix of finite elements >= 0 by the multiplicative updates of Lee and Seung (2001,
/// "Algorithms for non-negative matrix factorization") for the divergence
///   D(y | q) = sum y log(y / q) - y + q.
/// The thesis and Lawrence et al. (2004) use the updates for the Euclidean distance. The divergence suits
/// distributions better: it keeps the sums of rows and columns, hence energy, and q is nowhere 0 where y is
/// not, so that a pdf made of q covers y. Rank 1 is exact: the product of both sums. Runs on all cores, with
/// a result independent of their number.
NonnegativeFactors factorised(const Eigen::MatrixXd& y, Eigen::Index rank);

/// Returns the divergence D(y | left^T right).
double divergence(const Eigen::MatrixXd& y, const NonnegativeFactors& factors);

}  // namespace reflectance
