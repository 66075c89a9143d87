#include "renderer/fit/problem.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Core>

namespace fit {
namespace {

constexpr double Unlimited = 1e4;

/// Minimises w A w / 2 - b w for weights from 0 to their limits, by coordinate descent: a convex problem of
/// few unknowns.
void solve_bounded(const Eigen::MatrixXd& a, const Eigen::VectorXd& b, const Eigen::VectorXd& limits,
                   Eigen::VectorXd& weights) {
  constexpr int MostSweeps = 500;
  weights.setZero();
  for (int sweep = 0; sweep < MostSweeps; ++sweep) {
    double largest_change = 0;
    for (Eigen::Index i = 0; i < b.size(); ++i) {
      if (!(a(i, i) > 0)) continue;
      const double step = (b(i) - a.row(i).dot(weights)) / a(i, i);
      const double value = std::clamp(weights(i) + step, 0.0, limits(i));
      largest_change = std::max(largest_change, std::abs(value - weights(i)));
      weights(i) = value;
    }
    if (largest_change < 1e-10) break;
  }
}

}  // namespace

Problem::Problem(const std::vector<Lobe>& lobes, const Observations& observations, Metric metric)
    : lobes_(lobes),
      list_(observations.list),
      channels_(observations.is_grey ? 1 : 3),
      scale_(metric, mean_of(observations.list)) {
  for (std::size_t i = 0; i < lobes.size(); ++i) {
    first_shapes_.push_back(shape_count_);
    shape_count_ += lobes[i].shapes.size();
    if (lobes[i].has_weight) weights_.push_back({i, std::nullopt, std::nullopt, Unlimited});
    for (std::size_t colour = 0; colour < lobes[i].colours.size(); ++colour) {
      const double maximum = lobes.size() > 1 ? Unlimited : lobes[i].colours[colour].maximum;
      for (int channel = 0; channel < channels_; ++channel) {
        weights_.push_back({i, colour, channels_ == 1 ? std::nullopt : std::optional(channel), maximum});
      }
    }
  }
  targets_.reserve(list_.size() * static_cast<std::size_t>(channels_));
  for (const Observation& one : list_) {
    for (int channel = 0; channel < channels_; ++channel) {
      const double y = one.value[channel] * one.v.z;
      targets_.push_back(scale_.value(y));
      const double deviation = one.deviation * one.v.z * scale_.slope(y);
      factors_.push_back(deviation > 0 ? 1 / deviation : std::sqrt(one.weight));
    }
  }
}

Problem::Name Problem::name(std::size_t unknown) const {
  if (unknown >= shape_count_) {
    const Weight& weight = weights_[unknown - shape_count_];
    return {weight.lobe, std::nullopt, weight.colour, weight.channel};
  }
  std::size_t lobe = lobes_.size() - 1;
  while (first_shapes_[lobe] > unknown) --lobe;
  const std::size_t shape = unknown - first_shapes_[lobe];
  return {lobe, shape, std::nullopt, lobes_[lobe].shapes[shape].channel};
}

double Problem::scanned(std::size_t shape, double uniform) const {
  const Name place = name(shape);
  return lobes_[place.lobe].shapes[*place.shape].scanned(uniform);
}

std::vector<double> Problem::shapes_of(std::size_t lobe, std::span<const double> x) const {
  std::vector<double> values;
  for (std::size_t i = 0; i < lobes_[lobe].shapes.size(); ++i)
    values.push_back(lobes_[lobe].shapes[i].value(x[first_shapes_[lobe] + i]));
  return values;
}

std::vector<Vec3d> Problem::colours_of(std::size_t lobe, std::span<const double> x) const {
  std::vector<Vec3d> colours(lobes_[lobe].colours.size(), Vec3d(0));
  for (std::size_t i = 0; i < weights_.size(); ++i) {
    const Weight& weight = weights_[i];
    if (weight.lobe != lobe || !weight.colour) continue;
    const double value = x[shape_count_ + i];
    if (weight.channel) {
      colours[*weight.colour][*weight.channel] = value;
    } else {
      colours[*weight.colour] = Vec3d(value);
    }
  }
  return colours;
}

double Problem::weight_of(std::size_t lobe, std::span<const double> x) const {
  for (std::size_t i = 0; i < weights_.size(); ++i) {
    if (weights_[i].lobe == lobe && !weights_[i].colour) return x[shape_count_ + i];
  }
  return 1;
}

bool Problem::lobe_values(std::size_t lobe, std::span<const double> shapes, std::span<const Vec3d> colours,
                          Values& values) const {
  const auto brdf = brdf_of(lobes_[lobe], shapes, colours);
  if (!brdf) return false;
  fit::evaluate(*brdf, list_, values);
  return true;
}

std::optional<Problem::Parts> Problem::parts_of(std::size_t lobe, std::span<const double> x) const {
  const std::vector<double> shapes = shapes_of(lobe, x);
  std::vector<Vec3d> colours(lobes_[lobe].colours.size(), Vec3d(0));
  Parts parts;
  if (!lobe_values(lobe, shapes, colours, parts.none)) return std::nullopt;
  for (Vec3d& colour : colours) {
    colour = Vec3d(1);
    Values& values = parts.colours.emplace_back();
    if (!lobe_values(lobe, shapes, colours, values)) return std::nullopt;
    for (std::size_t k = 0; k < values.size(); ++k) values[k] -= parts.none[k];
    colour = Vec3d(0);
  }
  return parts;
}

void Problem::add_column(std::size_t unknown, const Values& change, std::optional<int> channel, double factor,
                         std::span<double> jacobian) const {
  const std::size_t columns = unknown_count();
  for (std::size_t k = 0; k < change.size(); ++k) {
    for (int c = 0; c < channels_; ++c) {
      if (channel && *channel != c) continue;
      const std::size_t row = k * static_cast<std::size_t>(channels_) + static_cast<std::size_t>(c);
      jacobian[row * columns + unknown] = factor * change[k][c];
    }
  }
}

bool Problem::add_shape_columns(std::size_t lobe, std::span<const double> x,
                                std::span<double> jacobian) const {
  constexpr double Step = 1e-5;
  const std::vector<Vec3d> colours = colours_of(lobe, x);
  const double lobe_weight = weight_of(lobe, x);
  const std::vector<double> shapes = shapes_of(lobe, x);
  Values after;
  Values before;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const ShapeParameter& shape = lobes_[lobe].shapes[i];
    const double t = x[first_shapes_[lobe] + i];
    std::vector<double> moved = shapes;
    moved[i] = shape.value(std::min(1.0, t + Step));
    double high = shape.coordinate(moved[i]);
    if (!lobe_values(lobe, moved, colours, after)) {
      high = shape.coordinate(shapes[i]);
      if (!lobe_values(lobe, shapes, colours, after)) return false;
    }
    moved[i] = shape.value(std::max(0.0, t - Step));
    double low = shape.coordinate(moved[i]);
    if (!lobe_values(lobe, moved, colours, before)) {
      low = shape.coordinate(shapes[i]);
      if (!lobe_values(lobe, shapes, colours, before)) return false;
    }
    if (!(high > low)) return false;
    for (std::size_t k = 0; k < after.size(); ++k) after[k] -= before[k];
    add_column(first_shapes_[lobe] + i, after, std::nullopt, lobe_weight / (high - low), jacobian);
  }
  return true;
}

void Problem::add_weight_columns(std::size_t lobe, const Parts& parts, double lobe_weight, const Values& own,
                                 std::span<double> jacobian) const {
  for (std::size_t i = 0; i < weights_.size(); ++i) {
    const Weight& weight = weights_[i];
    if (weight.lobe != lobe) continue;
    const Values& change = weight.colour ? parts.colours[*weight.colour] : own;
    add_column(shape_count_ + i, change, weight.channel, weight.colour ? lobe_weight : 1, jacobian);
  }
}

bool Problem::evaluate(std::span<const double> x, std::span<double> residuals,
                       std::span<double> jacobian) const {
  Values sum(list_.size(), Vec3d(0));
  Values own;
  std::fill(jacobian.begin(), jacobian.end(), 0.0);
  for (std::size_t lobe = 0; lobe < lobes_.size(); ++lobe) {
    const double lobe_weight = weight_of(lobe, x);
    const std::vector<Vec3d> colours = colours_of(lobe, x);
    if (jacobian.empty()) {
      if (!lobe_values(lobe, shapes_of(lobe, x), colours, own)) return false;
    } else {
      const auto parts = parts_of(lobe, x);
      if (!parts || !add_shape_columns(lobe, x, jacobian)) return false;
      own = parts->none;
      for (std::size_t i = 0; i < colours.size(); ++i) {
        for (std::size_t k = 0; k < own.size(); ++k) own[k] += parts->colours[i][k] * colours[i];
      }
      add_weight_columns(lobe, *parts, lobe_weight, own, jacobian);
    }
    for (std::size_t k = 0; k < own.size(); ++k) sum[k] += own[k] * lobe_weight;
  }
  const std::size_t columns = unknown_count();
  for (std::size_t row = 0; row < targets_.size(); ++row) {
    const Observation& one = list_[row / static_cast<std::size_t>(channels_)];
    const double y =
        sum[row / static_cast<std::size_t>(channels_)][static_cast<int>(row) % channels_] * one.v.z;
    residuals[row] = factors_[row] * (scale_.value(y) - targets_[row]);
    if (!std::isfinite(residuals[row])) return false;
    if (jacobian.empty()) continue;
    const double slope = factors_[row] * scale_.slope(y) * one.v.z;
    for (std::size_t i = 0; i < columns; ++i) jacobian[row * columns + i] *= slope;
  }
  return true;
}

bool Problem::solve_weights(std::span<double> x) const {
  if (weights_.empty()) return true;
  const auto rows = static_cast<Eigen::Index>(targets_.size());
  const auto count = static_cast<Eigen::Index>(weights_.size());
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(rows, count);
  Eigen::VectorXd rest = Eigen::VectorXd::Zero(rows);
  const std::size_t channels = static_cast<std::size_t>(channels_);
  for (std::size_t lobe = 0; lobe < lobes_.size(); ++lobe) {
    // A lobe with a weight has no linear colours: all of it is linear.
    const auto parts = parts_of(lobe, x);
    if (!parts) return false;
    for (Eigen::Index row = 0; row < rows; ++row) {
      const std::size_t k = static_cast<std::size_t>(row) / channels;
      const int channel = static_cast<int>(row) % channels_;
      if (!lobes_[lobe].has_weight) rest(row) -= parts->none[k][channel];
      for (Eigen::Index i = 0; i < count; ++i) {
        const Weight& weight = weights_[static_cast<std::size_t>(i)];
        if (weight.lobe != lobe || (weight.channel && *weight.channel != channel)) continue;
        columns(row, i) =
            weight.colour ? parts->colours[*weight.colour][k][channel] : parts->none[k][channel];
      }
    }
  }
  // The metric is linear about the data, with the slope at a thousandth of their mean below that.
  const double least = 1e-3 * mean_of(list_);
  for (Eigen::Index row = 0; row < rows; ++row) {
    const std::size_t k = static_cast<std::size_t>(row) / channels;
    const double value = list_[k].value[static_cast<int>(row) % channels_];
    const double slope = scale_.slope(std::max(least, value * list_[k].v.z)) * list_[k].v.z *
                         factors_[static_cast<std::size_t>(row)];
    rest(row) = (rest(row) + value) * slope;
    columns.row(row) *= slope;
  }
  if (!columns.allFinite() || !rest.allFinite()) return false;
  Eigen::VectorXd limits(count);
  for (Eigen::Index i = 0; i < count; ++i) limits(i) = weights_[static_cast<std::size_t>(i)].maximum;
  Eigen::VectorXd solved(count);
  solve_bounded(columns.transpose() * columns, columns.transpose() * rest, limits, solved);
  for (Eigen::Index i = 0; i < count; ++i) x[shape_count_ + static_cast<std::size_t>(i)] = solved(i);
  return true;
}

std::optional<double> Problem::cost(std::span<const double> x) const {
  std::vector<double> residuals(residual_count());
  if (!evaluate(x, residuals, {})) return std::nullopt;
  return std::inner_product(residuals.begin(), residuals.end(), residuals.begin(), 0.0) / 2;
}

double Problem::cost_of_black() const {
  double sum = 0;
  for (std::size_t row = 0; row < targets_.size(); ++row) {
    const double residual = factors_[row] * (targets_[row] - scale_.value(0));
    sum += residual * residual;
  }
  return sum / 2;
}

}  // namespace fit
