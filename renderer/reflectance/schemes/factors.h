#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/reflectance/schemes/direction_grid.h"

namespace reflectance {

/// The resolution of a factorisation.
struct FactorSize {
  std::size_t view_angles = 0;    ///< theta_u
  std::size_t view_azimuths = 0;  ///< phi_u; 1 for an isotropic BRDF
  std::size_t rows = 0;           ///< theta_w
  std::size_t columns = 0;        ///< phi_w
  std::size_t view_factors = 0;   ///< J
  std::size_t factors = 0;        ///< K, per view factor
  bool by_half = false;           ///< w is h, else v

  std::size_t lobes() const { return view_factors * factors; }
  std::size_t views() const { return view_angles * view_azimuths; }

  bool operator==(const FactorSize&) const = default;
};

/// A BRDF times the cosine as a sum of lobes F(u) T(theta_w) P(phi_w), for the scheme `factored`.
class Factors {
 public:
  static constexpr std::size_t MostLobes = 64;

  /// The fraction of samples that is uniform over the hemisphere of w, where there may be no lobe.
  static constexpr float Floor = 0.01F;

  /// Computes two non-negative factorisations. The matrix has f cos(theta_v) (times 4 u.h if w is h) for all
  /// cells of w (rows) and views (columns), rows weighted by solid angle and columns by 1 / their sum, since
  /// all views are equally important. It is split into `view_factors` products of views and cells; the cells
  /// of each, as a matrix of theta and phi, are split into `factors` products.
  static Factors make(const Brdf& brdf, const FactorSize& size);

  /// Makes factors from the values of `view_weights` and `curves`: sizes must match, weights be in [0,1], and
  /// cdfs rise from 0 to 1.
  Factors(const FactorSize& size, std::vector<float> view_weights, std::vector<float> curves);

  const FactorSize& size() const { return size_; }

  /// Returns F, normalised per view, with the lobe running first, then theta_u, then phi_u. Views are the
  /// centres of evenly spaced intervals.
  const std::vector<float>& view_weights() const { return view_weights_; }

  /// Returns for each lobe the cdf of theta_w, at `rows` + 1 edges, and that of phi_w.
  const std::vector<float>& curves() const { return curves_; }

  /// Samples w above the horizon for a view above the horizon: `choice` picks a lobe, `direction` gives theta
  /// and phi. For an isotropic BRDF it is in the frame of u's plane.
  Vec3f direction(const Vec3f& u, const Uniforms& xi) const;

  /// Returns the pdf of the whole mixture, per solid angle of w.
  float pdf(const Vec3f& u, const Vec3f& w) const;

  std::size_t bytes() const;

  friend bool operator==(const Factors&, const Factors&) = default;

 private:
  using Weights = std::array<float, MostLobes + 1>;  // the last of those in use is the floor's

  Weights lobe_weights(const Vec3f& u) const;
  std::span<const float> theta_curve(std::size_t lobe) const;
  std::span<const float> phi_curve(std::size_t lobe) const;

  FactorSize size_;
  DirectionGrid grid_;
  std::vector<float> view_weights_;
  std::vector<float> curves_;
};

}  // namespace reflectance
