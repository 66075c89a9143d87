#include "renderer/reflectance/bilinear_warp.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace reflectance {
namespace {

/// A place between two entries of a list: the lower one's index, and the fraction of the way to the next.
struct Between {
  std::size_t lower = 0;
  double fraction = 0;
};

/// Finds a value in an ascending list, clamped to its ends.
Between find_between(const std::vector<float>& ascending, double value) {
  if (ascending.size() < 2) return {};
  const auto above = std::upper_bound(ascending.begin() + 1, ascending.end() - 1, value);
  const auto lower = static_cast<std::size_t>(above - ascending.begin()) - 1;
  const double start = ascending[lower];
  return {lower, std::clamp((value - start) / (ascending[lower + 1] - start), 0.0, 1.0)};
}

/// Finds a coordinate from 0 to 1 between evenly spaced nodes; NaN is 0.
Between between_nodes(double coordinate, std::size_t count) {
  if (count < 2 || !(coordinate > 0)) return {};
  const double scaled = std::min(coordinate, 1.0) * static_cast<double>(count - 1);
  const std::size_t lower = std::min(static_cast<std::size_t>(scaled), count - 2);
  return {lower, scaled - static_cast<double>(lower)};
}

double lerp(double a, double b, double t) { return (1 - t) * a + t * b; }

/// Returns the integral from 0 to t of a density that is a at 0 and b at 1.
double integral_to(double t, double a, double b) { return t * (a + 0.5 * t * (b - a)); }

/// Returns the t from 0 to 1 up to which that integral has the given value. No digits cancel.
double inverse_integral(double value, double a, double b) {
  const double below = a + std::sqrt(std::max(0.0, a * a + 2 * (b - a) * value));
  return below > 0 ? std::clamp(2 * value / below, 0.0, 1.0) : 0.5;
}

/// Returns the cell that a value of a cumulative distribution falls into: of `count` nodes, the last but one
/// at most.
template <class Cumulative>
std::size_t find_cell(const Cumulative& cumulative, std::size_t count, double value) {
  std::size_t first = 0;
  std::size_t last = count - 1;
  while (last - first > 1) {
    const std::size_t middle = first + (last - first) / 2;
    (cumulative(middle) <= value ? first : last) = middle;
  }
  return first;
}

}  // namespace

SliceGrid::SliceGrid(std::vector<float> outer, std::vector<float> inner)
    : outer_(std::move(outer)), inner_(std::move(inner)) {
  assert(!outer_.empty() && !inner_.empty());
}

SliceWeights SliceGrid::around(double outer, double inner) const {
  const Between row = find_between(outer_, outer);
  const Between column = find_between(inner_, inner);
  const std::size_t next_row = std::min(row.lower + 1, outer_.size() - 1);
  const std::size_t next_column = std::min(column.lower + 1, inner_.size() - 1);
  const std::size_t start = row.lower * inner_.size();
  const std::size_t next_start = next_row * inner_.size();
  return {{start + column.lower, start + next_column, next_start + column.lower, next_start + next_column},
          {(1 - row.fraction) * (1 - column.fraction), (1 - row.fraction) * column.fraction,
           row.fraction * (1 - column.fraction), row.fraction * column.fraction}};
}

BilinearTable::BilinearTable(const NodeGrid& grid, std::size_t channel_count, std::vector<float> values)
    : grid_(grid), channel_count_(channel_count), values_(std::move(values)) {
  assert(values_.size() % (channel_count_ * grid_.node_count()) == 0);
}

double BilinearTable::evaluate(const Vec2d& point, const SliceWeights& slices, std::size_t channel) const {
  const Between x = between_nodes(point.x, grid_.width);
  const Between y = between_nodes(point.y, grid_.height);
  const std::size_t right = grid_.width > 1 ? 1 : 0;
  const std::size_t up = grid_.height > 1 ? grid_.width : 0;
  const std::size_t corner = x.lower + y.lower * grid_.width;
  return slices.interpolate([&](std::size_t slice) {
    const float* node = values_.data() + (slice * channel_count_ + channel) * grid_.node_count() + corner;
    return lerp(lerp(node[0], node[right], x.fraction), lerp(node[up], node[up + right], x.fraction),
                y.fraction);
  });
}

BilinearTable BilinearTable::mixed(const std::vector<std::vector<double>>& weights) const {
  const std::size_t nodes = grid_.node_count();
  const std::size_t slice_count = values_.size() / (channel_count_ * nodes);
  std::vector<float> values;
  values.reserve(slice_count * weights.size() * nodes);
  std::vector<double> sums(nodes);
  for (std::size_t slice = 0; slice < slice_count; ++slice) {
    for (const std::vector<double>& row : weights) {
      std::fill(sums.begin(), sums.end(), 0.0);
      const float* value = values_.data() + slice * channel_count_ * nodes;
      for (std::size_t channel = 0; channel < channel_count_; ++channel) {
        for (double& sum : sums) sum += row[channel] * double(*value++);
      }
      for (const double sum : sums) values.push_back(static_cast<float>(sum));
    }
  }
  return {grid_, weights.size(), std::move(values)};
}

BilinearWarp::BilinearWarp(const NodeGrid& grid, const std::vector<float>& values) : grid_(grid) {
  assert(grid.width > 1 && grid.height > 1 && values.size() % grid.node_count() == 0);
  densities_.reserve(values.size());
  row_cumulative_.reserve(values.size());
  for (std::size_t first = 0; first < values.size(); first += grid.node_count()) {
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first);
    add_slice({begin, begin + static_cast<std::ptrdiff_t>(grid.node_count())});
  }
}

void BilinearWarp::add_slice(std::vector<double> densities) {
  const auto row_sum = [&](std::size_t y) {
    const auto row = densities.begin() + static_cast<std::ptrdiff_t>(y * grid_.width);
    double sum = -0.5 * (row[0] + row[static_cast<std::ptrdiff_t>(grid_.width) - 1]);
    for (std::size_t x = 0; x < grid_.width; ++x) sum += row[static_cast<std::ptrdiff_t>(x)];
    return sum;
  };
  double total = -0.5 * (row_sum(0) + row_sum(grid_.height - 1));
  for (std::size_t y = 0; y < grid_.height; ++y) total += row_sum(y);
  if (!(total > 0)) {
    std::fill(densities.begin(), densities.end(), 1.0);
    total = static_cast<double>((grid_.width - 1) * (grid_.height - 1));
  }
  for (double& density : densities) density /= total;
  double below = 0;
  double last_row = 0;
  for (std::size_t y = 0; y < grid_.height; ++y) {
    const double* row = densities.data() + y * grid_.width;
    double sum = 0;
    row_cumulative_.push_back(0);
    for (std::size_t x = 1; x < grid_.width; ++x) {
      sum += 0.5 * (row[x - 1] + row[x]);
      row_cumulative_.push_back(sum);
    }
    if (y > 0) below += 0.5 * (last_row + sum);
    marginal_.push_back(below);
    last_row = sum;
  }
  densities_.insert(densities_.end(), densities.begin(), densities.end());
}

double BilinearWarp::density(std::size_t x, std::size_t y, const SliceWeights& slices) const {
  const double* first = densities_.data() + x + y * grid_.width;
  return slices.interpolate([&](std::size_t slice) { return first[slice * grid_.node_count()]; });
}

double BilinearWarp::row_cumulative(std::size_t x, std::size_t y, const SliceWeights& slices) const {
  const double* first = row_cumulative_.data() + x + y * grid_.width;
  return slices.interpolate([&](std::size_t slice) { return first[slice * grid_.node_count()]; });
}

double BilinearWarp::marginal(std::size_t y, const SliceWeights& slices) const {
  return slices.interpolate([&](std::size_t slice) { return marginal_[slice * grid_.height + y]; });
}

WarpedPoint BilinearWarp::sample(const Vec2d& uniform, const SliceWeights& slices) const {
  const std::size_t last = grid_.width - 1;
  const std::size_t y =
      find_cell([&](std::size_t row) { return marginal(row, slices); }, grid_.height, uniform.y);
  const double up = inverse_integral(std::max(0.0, uniform.y - marginal(y, slices)),
                                     row_cumulative(last, y, slices), row_cumulative(last, y + 1, slices));
  const auto cumulative = [&](std::size_t x) {
    return lerp(row_cumulative(x, y, slices), row_cumulative(x, y + 1, slices), up);
  };
  const double target = uniform.x * cumulative(last);
  const std::size_t x = find_cell(cumulative, grid_.width, target);
  const double left = lerp(density(x, y, slices), density(x, y + 1, slices), up);
  const double right = lerp(density(x + 1, y, slices), density(x + 1, y + 1, slices), up);
  const double along = inverse_integral(std::max(0.0, target - cumulative(x)), left, right);
  const auto cells_x = static_cast<double>(last);
  const auto cells_y = static_cast<double>(grid_.height - 1);
  return {{(static_cast<double>(x) + along) / cells_x, (static_cast<double>(y) + up) / cells_y},
          lerp(left, right, along) * cells_x * cells_y};
}

WarpedPoint BilinearWarp::invert(const Vec2d& point, const SliceWeights& slices) const {
  const std::size_t last = grid_.width - 1;
  const Between x = between_nodes(point.x, grid_.width);
  const Between y = between_nodes(point.y, grid_.height);
  const auto in_row = [&](double lower, double upper) { return lerp(lower, upper, y.fraction); };
  const double left = in_row(density(x.lower, y.lower, slices), density(x.lower, y.lower + 1, slices));
  const double right =
      in_row(density(x.lower + 1, y.lower, slices), density(x.lower + 1, y.lower + 1, slices));
  const double lower_row = row_cumulative(last, y.lower, slices);
  const double upper_row = row_cumulative(last, y.lower + 1, slices);
  const double row = in_row(lower_row, upper_row);
  const double before =
      in_row(row_cumulative(x.lower, y.lower, slices), row_cumulative(x.lower, y.lower + 1, slices));
  // Where a row has no density, any x is as good.
  const double along = row > 0 ? (before + integral_to(x.fraction, left, right)) / row : point.x;
  const double below = marginal(y.lower, slices) + integral_to(y.fraction, lower_row, upper_row);
  const auto cells = static_cast<double>(last * (grid_.height - 1));
  return {{std::clamp(along, 0.0, 1.0), std::clamp(below, 0.0, 1.0)}, lerp(left, right, x.fraction) * cells};
}

double BilinearWarp::pdf(const Vec2d& point, const SliceWeights& slices) const {
  return invert(point, slices).pdf;
}

}  // namespace reflectance
