#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/reflectance/schemes/direction_grid.h"

namespace reflectance {

/// Tabulated cdfs of the half vector for all views of a BRDF, for the scheme `cascadeCDF`.
class CascadeTables {
 public:
  static constexpr std::size_t ViewAngles = 32;
  static constexpr std::size_t ViewAzimuths = 16;  ///< of an anisotropic BRDF

  // The largest errors of compressed cdfs, in probability. With these, tables of 256 x 32 cells need about a
  // twentieth of the memory, and the weights' standard deviation, in albedos, grows from 0.16 to 0.19 for
  // Ward's model with sx=0.2 and from 0.37 to 0.38 for Lewis' with n=100.
  static constexpr float MarginalTolerance = 0.002F;
  static constexpr float ConditionalTolerance = 0.005F;

  struct Size {
    std::size_t rows = 0;
    std::size_t columns = 0;
  };

  CascadeTables(const Brdf& brdf, const Size& size, bool compress);

  /// Samples an h above the horizon, for a view above the horizon.
  Vec3f half_vector(const Vec3f& u, const Vec2f& xi) const;

  /// Returns the pdf per solid angle of h, which is above 0 everywhere: see `Floor` in the source.
  float half_pdf(const Vec3f& u, const Vec3f& h) const;

  std::size_t bytes() const;

  friend bool operator==(const CascadeTables&, const CascadeTables&) = default;

 private:
  /// The cdfs of some views in sequence: for each view the marginal cdf, then a conditional cdf per piece.
  struct Curves {
    std::vector<float> values;          ///< of the cdfs' points
    std::vector<std::uint16_t> points;  ///< the grid edges of these points; empty: all of them
    std::vector<std::uint32_t> begins;  ///< the first index of each cdf in the two above, and an end

    bool operator==(const Curves&) const = default;
  };

  /// A view of one cdf.
  struct Curve {
    std::span<const float> values;
    const std::uint16_t* points = nullptr;

    std::size_t point(std::size_t i) const { return points == nullptr ? i : points[i]; }
    std::size_t piece_with(std::size_t cell) const;
  };

  Curves make_view(const Brdf& brdf, std::size_t view, bool compress) const;
  std::vector<double> masses(const Brdf& brdf, std::size_t view) const;
  void append_compressed(Curves& curves, std::span<const double> masses) const;
  void append_plain(Curves& curves, std::span<const double> masses) const;
  void append(const Curves& view);

  std::size_t view_of(const Vec3f& u) const;
  Curve curve(std::size_t index) const;

  DirectionGrid grid_;
  bool is_anisotropic_ = false;
  Curves curves_;
  std::vector<std::uint32_t> marginals_;  ///< the index of each view's marginal cdf
};

}  // namespace reflectance
