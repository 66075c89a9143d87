#pragma once

#include <Eigen/Core>

namespace reflectance {

/// Non-negative matrices whose product left^T right is near a given one.
struct NonnegativeFactors {
  Eigen::MatrixXd left;   ///< rank x rows of the given one
  Eigen::MatrixXd right;  ///< rank x columns
};

/// Factorises a matrix whose elements are finite and >= 0 by the multiplicative updates of Lee and Seung
/// (2001, "Algorithms for non-negative matrix factorization"), those for the divergence
///   D(y | q) = sum y log(y / q) - y + q.
/// The thesis and Lawrence et al. (2004) take the updates for the Euclidean distance. For distributions the
/// divergence is the better one: sums of rows and columns are kept, so that energies are right, and q is
/// nowhere 0 where y is not, so that a density made of q misses nothing. For rank 1 the answer is exact: the
/// product of both sums. All cores work on it, and the result does not depend on how many there are.
NonnegativeFactors factorised(const Eigen::MatrixXd& y, Eigen::Index rank);

/// D(y | left^T right).
double divergence(const Eigen::MatrixXd& y, const NonnegativeFactors& factors);

}  // namespace reflectance
