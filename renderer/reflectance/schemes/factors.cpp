#include "renderer/reflectance/schemes/factors.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "renderer/parallel/loops.h"
#include "renderer/reflectance/schemes/cumulative.h"
#include "renderer/reflectance/schemes/nonnegative_factors.h"

namespace reflectance {
namespace {

/// Views with smaller lobe weights, as between a view that sees light and one that sees none, have no lobes.
constexpr float LeastWeight = 1e-6F;

using Eigen::Index;
using Eigen::MatrixXd;

Vec3f view_at(const FactorSize& size, std::size_t view) {
  const float theta =
      Pi / 2 * (static_cast<float>(view % size.view_angles) + 0.5F) / static_cast<float>(size.view_angles);
  const float turns =
      (static_cast<float>(view / size.view_angles) + 0.5F) / static_cast<float>(size.view_azimuths);
  return from_angles(std::cos(theta), std::sin(theta), size.view_azimuths > 1 ? 2 * Pi * turns : 0);
}

/// Returns a view's distribution over cells in row order; its sum is 1, or 0.
Eigen::VectorXd seen_from(const Brdf& brdf, const Vec3f& u, const DirectionGrid& grid, bool by_half) {
  const auto scalar = by_half ? scalar_of_half : scalar_of_direction;
  const CellPoints points(grid, 128, 64);
  Eigen::VectorXd masses(static_cast<Index>(grid.rows() * grid.columns()));
  for (Index cell = 0; cell < masses.size(); ++cell) {
    const std::size_t row = static_cast<std::size_t>(cell) / grid.columns();
    const std::size_t column = static_cast<std::size_t>(cell) % grid.columns();
    double sum = 0;
    for (std::size_t i = 0; i < points.down(); ++i) {
      for (std::size_t k = 0; k < points.across(); ++k) {
        sum += scalar(brdf, u, points.direction(row, column, i, k));
      }
    }
    masses(cell) = sum * grid.solid_angle(row, row + 1, 1);
  }
  const double sum = masses.sum();
  return sum > 0 ? Eigen::VectorXd(masses / sum) : masses;
}

/// The lobes of one of the J factors.
struct Lobes {
  std::vector<float> curves;
  std::vector<double> fractions;  ///< fractions of its energy, which sum to 1
};

Lobes split(const Eigen::VectorXd& cells, const FactorSize& size) {
  const MatrixXd by_theta = Eigen::Map<const MatrixXd>(cells.data(), static_cast<Index>(size.columns),
                                                       static_cast<Index>(size.rows))
                                .transpose();
  const NonnegativeFactors parts = factorised(by_theta, static_cast<Index>(size.factors));
  Lobes lobes;
  double whole = 0;
  for (Index k = 0; k < parts.left.rows(); ++k) {
    for (const MatrixXd& side : {parts.left, parts.right}) {
      const Eigen::VectorXd masses = side.row(k);
      const std::vector<float> curve = cumulative({masses.data(), static_cast<std::size_t>(masses.size())});
      lobes.curves.insert(lobes.curves.end(), curve.begin(), curve.end());
    }
    lobes.fractions.push_back(parts.left.row(k).sum() * parts.right.row(k).sum());
    whole += lobes.fractions.back();
  }
  for (double& fraction : lobes.fractions) fraction = whole > 0 ? fraction / whole : 0;
  return lobes;
}

/// The two nearest of evenly spaced centres in [0,1], with the weight of the second.
struct Neighbours {
  std::size_t first = 0, second = 0;
  float fraction = 0;
};

Neighbours neighbours(float place, std::size_t count, bool is_round) {
  const float centres = place * static_cast<float>(count) - 0.5F;
  const float floor = std::floor(centres);
  const auto last = static_cast<std::ptrdiff_t>(count) - 1;
  const auto index = [&](std::ptrdiff_t i) {
    if (is_round) return static_cast<std::size_t>(i < 0 ? last : i > last ? 0 : i);
    return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, last));
  };
  const auto below = static_cast<std::ptrdiff_t>(floor);
  return {index(below), index(below + 1), centres - floor};
}

}  // namespace

Factors Factors::make(const Brdf& brdf, const FactorSize& size) {
  const DirectionGrid grid(size.rows, size.columns);
  MatrixXd seen(static_cast<Index>(size.rows * size.columns), static_cast<Index>(size.views()));
  parallel::for_each_index(size.views(), [&](std::size_t view) {
    seen.col(static_cast<Index>(view)) = seen_from(brdf, view_at(size, view), grid, size.by_half);
  });
  const NonnegativeFactors outer = factorised(seen, static_cast<Index>(size.view_factors));
  std::vector<Lobes> lobes(size.view_factors);
  parallel::for_each_index(
      lobes.size(), [&](std::size_t j) { lobes[j] = split(outer.left.row(static_cast<Index>(j)), size); });
  std::vector<float> weights;
  for (Index view = 0; view < outer.right.cols(); ++view) {
    const Eigen::VectorXd energies = outer.right.col(view).cwiseProduct(outer.left.rowwise().sum());
    const double whole = energies.sum();
    for (std::size_t j = 0; j < lobes.size(); ++j) {
      const double energy = whole > 0 ? energies(static_cast<Index>(j)) / whole : 0;
      for (const double fraction : lobes[j].fractions)
        weights.push_back(static_cast<float>(energy * fraction));
    }
  }
  std::vector<float> curves;
  for (const Lobes& some : lobes) curves.insert(curves.end(), some.curves.begin(), some.curves.end());
  return {size, std::move(weights), std::move(curves)};
}

Factors::Factors(const FactorSize& size, std::vector<float> view_weights, std::vector<float> curves)
    : size_(size),
      grid_(size.rows, size.columns),
      view_weights_(std::move(view_weights)),
      curves_(std::move(curves)) {}

std::span<const float> Factors::theta_curve(std::size_t lobe) const {
  return std::span(curves_).subspan(lobe * (size_.rows + size_.columns + 2), size_.rows + 1);
}
std::span<const float> Factors::phi_curve(std::size_t lobe) const {
  const std::size_t begin = lobe * (size_.rows + size_.columns + 2) + size_.rows + 1;
  return std::span(curves_).subspan(begin, size_.columns + 1);
}

Factors::Weights Factors::lobe_weights(const Vec3f& u) const {
  const std::size_t lobes = size_.lobes();
  Weights weights;
  std::fill_n(weights.begin(), lobes, 0.0F);
  const auto add = [&](std::size_t angle, std::size_t azimuth, float fraction) {
    const float* of_view = view_weights_.data() + (azimuth * size_.view_angles + angle) * lobes;
    for (std::size_t i = 0; i < lobes; ++i) weights[i] += fraction * of_view[i];
  };
  const Neighbours angle = neighbours(right_angles_of(versine_of(u)), size_.view_angles, false);
  const Neighbours azimuth =
      size_.view_azimuths > 1 ? neighbours(turns_of(u), size_.view_azimuths, true) : Neighbours();
  for (const auto& [i, fraction] :
       {std::pair(azimuth.first, 1 - azimuth.fraction), std::pair(azimuth.second, azimuth.fraction)}) {
    if (!(fraction > 0)) continue;
    add(angle.first, i, fraction * (1 - angle.fraction));
    add(angle.second, i, fraction * angle.fraction);
  }
  float sum = 0;
  for (std::size_t i = 0; i < lobes; ++i) sum += weights[i];
  const bool has_lobes = sum > LeastWeight;
  const float scale = has_lobes ? (1 - Floor) / sum : 0;
  for (std::size_t i = 0; i < lobes; ++i) weights[i] *= scale;
  weights[lobes] = has_lobes ? Floor : 1;
  return weights;
}

Vec3f Factors::direction(const Vec3f& u, const Uniforms& xi) const {
  const Weights weights = lobe_weights(u);
  const std::size_t floor = size_.lobes();
  std::size_t lobe = 0;
  for (float left = xi.choice; lobe < floor && left >= weights[lobe]; ++lobe) left -= weights[lobe];
  if (lobe == floor) return uniform_direction(xi.direction);
  const CdfPosition row = inverted(theta_curve(lobe), xi.direction.x);
  const CdfPosition column = inverted(phi_curve(lobe), xi.direction.y);
  const float turned = static_cast<float>(column.cell) + column.fraction;
  const Vec3f w = grid_.direction(row.cell, row.cell + 1, row.fraction, turned);
  return size_.view_azimuths > 1 ? w : AzimuthRotation(u).from_plane(w);
}

float Factors::pdf(const Vec3f& u, const Vec3f& w) const {
  const Vec3f turned = size_.view_azimuths > 1 ? w : AzimuthRotation(u).to_plane(w);
  const std::size_t row = grid_.row_of(turned);
  const std::size_t column = grid_.column_of(turned);
  const Weights weights = lobe_weights(u);
  const std::size_t stride = size_.rows + size_.columns + 2;
  const float* theta = curves_.data() + row;
  const float* phi = curves_.data() + size_.rows + 1 + column;
  float mass = 0;
  for (std::size_t i = 0; i < size_.lobes(); ++i, theta += stride, phi += stride) {
    mass += weights[i] * (theta[1] - theta[0]) * (phi[1] - phi[0]);
  }
  return mass / grid_.solid_angle(row, row + 1, 1) + weights[size_.lobes()] / (2 * Pi);
}

std::size_t Factors::bytes() const {
  return sizeof(*this) + grid_.bytes() + (view_weights_.size() + curves_.size()) * sizeof(float);
}

}  // namespace reflectance
