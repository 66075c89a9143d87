// The least-squares problem of a fit: its unknowns, residuals and derivatives.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "renderer/fit/lobe.h"
#include "renderer/fit/metric.h"
#include "renderer/fit/observations.h"

namespace fit {

/// The residuals of lobes against observations. The unknowns x are the coordinates of the shapes of all lobes
/// in order, each from 0 to 1, then the weights, which enter linearly: of a lobe its own weight, if it has
/// one, and its linear colours, per channel unless the observations are grey. The residuals are those of
/// each observation's channels, T(f cos) - T(data cos), times the root of the weight; with a standard
/// deviation, over that of T(data cos).
class Problem {
 public:
  /// The mean of f cos in the metric is that of the observations. Keeps references to the lobes and
  /// observations.
  Problem(const std::vector<Lobe>& lobes, const Observations& observations, Metric metric);

  std::size_t unknown_count() const { return shape_count_ + weights_.size(); }
  std::size_t shape_count() const { return shape_count_; }
  std::size_t residual_count() const { return targets_.size(); }
  /// Returns the number of residuals of an observation, which follow each other: 1 if all are grey, else 3.
  int channels() const { return channels_; }
  /// Returns the largest value of an unknown; the least is 0. Weights in sums have no limit.
  double upper(std::size_t unknown) const {
    return unknown < shape_count_ ? 1 : weights_[unknown - shape_count_].maximum;
  }

  /// Returns the coordinate of a shape for a uniform number of a scan; see ShapeParameter.
  double scanned(std::size_t shape, double uniform) const;

  /// Computes the residuals and, unless it is empty, the Jacobian, one row per residual. Derivatives by
  /// weights are exact. Those by shapes are central differences over a step of 1e-5 of the range: the values
  /// are doubles for which the parameter, a float, is exact at both ends, so that they are good to about
  /// 1e-8. Returns false where a model does not take the values.
  bool evaluate(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian) const;

  /// Sets the weights by non-negative least squares in the linearised metric, for the shapes of x. Returns
  /// false where a model does not take these.
  bool solve_weights(std::span<double> x) const;

  /// Returns half of the sum of squared residuals, or nothing where a model does not take the values.
  std::optional<double> cost(std::span<const double> x) const;
  /// Returns half of the sum of squared residuals of a black BRDF.
  double cost_of_black() const;

  /// Names an unknown for its owner.
  struct Name {
    std::size_t lobe = 0;
    std::optional<std::size_t> shape;   ///< index of the lobe's shape
    std::optional<std::size_t> colour;  ///< or of its linear colour; else it is the lobe's weight
    std::optional<int> channel;         ///< of that; else all have the value
  };
  Name name(std::size_t unknown) const;

  // These return what x means for a lobe.
  std::vector<double> shapes_of(std::size_t lobe, std::span<const double> x) const;
  std::vector<Vec3d> colours_of(std::size_t lobe, std::span<const double> x) const;
  double weight_of(std::size_t lobe, std::span<const double> x) const;

 private:
  using Values = std::vector<Vec3d>;
  struct Weight {
    std::size_t lobe = 0;
    std::optional<std::size_t> colour;  ///< else the lobe's own weight
    std::optional<int> channel;
    double maximum = 1;
  };
  /// The values of a lobe without its linear colours, and what each of them, white, adds.
  struct Parts {
    Values none;
    std::vector<Values> colours;
  };

  bool lobe_values(std::size_t lobe, std::span<const double> shapes, std::span<const Vec3d> colours,
                   Values& values) const;
  std::optional<Parts> parts_of(std::size_t lobe, std::span<const double> x) const;
  bool add_shape_columns(std::size_t lobe, std::span<const double> x, std::span<double> jacobian) const;
  void add_weight_columns(std::size_t lobe, const Parts& parts, double lobe_weight, const Values& own,
                          std::span<double> jacobian) const;
  void add_column(std::size_t unknown, const Values& change, std::optional<int> channel, double factor,
                  std::span<double> jacobian) const;

  const std::vector<Lobe>& lobes_;
  const std::vector<Observation>& list_;
  int channels_;
  MetricScale scale_;
  std::vector<std::size_t> first_shapes_;  ///< of each lobe in x
  std::size_t shape_count_ = 0;
  std::vector<Weight> weights_;
  // These lists have a number for each residual.
  std::vector<double> targets_;  ///< T(data cos)
  std::vector<double> factors_;
};

}  // namespace fit
