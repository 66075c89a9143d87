#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/reflectance/schemes/direction_grid.h"

namespace reflectance {

/// What a factorisation is made with.
struct FactorSize {
  std::size_t view_angles = 0;    ///< theta_u
  std::size_t view_azimuths = 0;  ///< phi_u; 1 for an isotropic BRDF
  std::size_t rows = 0;           ///< theta_w
  std::size_t columns = 0;        ///< phi_w
  std::size_t view_factors = 0;   ///< J
  std::size_t factors = 0;        ///< K, of each of the J
  bool by_half = false;           ///< w is h, and v if not

  std::size_t lobes() const { return view_factors * factors; }
  std::size_t views() const { return view_angles * view_azimuths; }

  bool operator==(const FactorSize&) const = default;
};

/// A BRDF times the cosine as a sum of lobes, F(u) T(theta_w) P(phi_w) each, for the scheme `factored`.
class Factors {
 public:
  static constexpr std::size_t MostLobes = 64;

  /// The share of samples that is spread evenly over the hemisphere of w, where no lobe may be.
  static constexpr float Floor = 0.01F;

  /// Two non-negative factorisations. f cos(theta_v) (times 4 u.h where w is h) of all cells of w (rows) and
  /// views (columns), each row weighted by its cells' solid angle and each column by 1 / its sum, since all
  /// views are as important, is first split into `view_factors` products of views and cells. The cells of
  /// each of these, as a matrix of theta and phi, are then split into `factors` products.
  static Factors make(const Brdf& brdf, const FactorSize& size);

  /// From what `view_weights` and `curves` say: the sizes fit, weights are in [0,1], and curves rise from 0
  /// to 1.
  Factors(const FactorSize& size, std::vector<float> view_weights, std::vector<float> curves);

  const FactorSize& size() const { return size_; }

  /// F: for each azimuth of u each angle theta_u, and for that each lobe; as shares of the view's light. The
  /// views are the centres of as many even parts of the range.
  const std::vector<float>& view_weights() const { return view_weights_; }

  /// For each lobe the cumulative distribution of theta_w, at `rows` + 1 edges, and that of phi_w.
  const std::vector<float>& curves() const { return curves_; }

  /// w over the horizon for a view over the horizon: by `choice` a lobe is picked, by `direction` theta and
  /// phi. In the frame of u's plane for an isotropic BRDF.
  Vec3f direction(const Vec3f& u, const Uniforms& xi) const;

  /// Per solid angle of w: the whole mixture.
  float density(const Vec3f& u, const Vec3f& w) const;

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
