#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "renderer/reflectance/geometry.h"

namespace statistics {

/// As ChiSquareTest, for a density per projected solid angle that is constant in each cell of a grid over the
/// square about the unit disc: no quadrature has to find its steps.
class DiscChiSquareTest {
 public:
  using Sampler = std::function<std::optional<reflectance::Vec3f>()>;

  /// `density` is per solid angle. The grid of resolution^2 cells lies along u's azimuth.
  DiscChiSquareTest(const std::function<double(const reflectance::Vec3f&)>& density,
                    const reflectance::Vec3f& u, int resolution);

  double p_value(const Sampler& sampler, int samples) const;

  /// The density's integral over the hemisphere.
  double mass() const;

 private:
  static constexpr int Blocks = 20;  // along an edge

  std::size_t block_of(double x, double y) const;

  float cosine_;
  float sine_;
  int resolution_;
  std::vector<double> probabilities_;  ///< of the blocks, and last of no sample
};

}  // namespace statistics
