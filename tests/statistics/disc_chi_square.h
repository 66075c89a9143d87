#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "renderer/reflectance/geometry.h"

namespace statistics {

/// A chi-square test for a pdf per projected solid angle that is constant in each cell of a grid over the
/// unit disc's square: no quadrature has to find its steps.
class DiscChiSquareTest {
 public:
  using Sampler = std::function<std::optional<reflectance::Vec3f>()>;

  /// Takes a solid-angle pdf. The grid of resolution^2 cells is aligned with u's azimuth.
  DiscChiSquareTest(const std::function<double(const reflectance::Vec3f&)>& pdf, const reflectance::Vec3f& u,
                    int resolution);

  double p_value(const Sampler& sampler, int samples) const;

  /// Returns the pdf's integral over the hemisphere.
  double mass() const;

 private:
  static constexpr int Blocks = 20;  // along an edge

  std::size_t block_of(double x, double y) const;

  float cosine_;
  float sine_;
  int resolution_;
  std::vector<double> probabilities_;  ///< of the blocks, and last of empty samples
};

}  // namespace statistics
