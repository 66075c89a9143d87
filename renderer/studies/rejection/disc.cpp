#include "renderer/studies/rejection/disc.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "renderer/reflectance/schemes/rejection_trees.h"
#include "renderer/studies/rejection/random.h"

namespace studies {
namespace {

using plot::Point;
using reflectance::DiscGrid;
using reflectance::RejectionTree;
using reflectance::Vec3f;

reflectance::Vec3f over(const Point& point) {
  const double height2 = std::max(0.0, 1 - point.x * point.x - point.y * point.y);
  return {static_cast<float>(point.x), static_cast<float>(point.y), static_cast<float>(std::sqrt(height2))};
}

double rim() { return std::sin(LimitDegrees * Degree); }

/// Moves a point beyond the rim onto it.
Point within_rim(const Point& point) {
  const double radius = point.length();
  return radius > rim() ? point * (rim() / radius) : point;
}

/// Returns places that a maximum may be near.
std::vector<Peak> candidates(const DiscFunction& function) {
  constexpr int Thetas = 60;
  constexpr int Phis = 96;
  constexpr std::uint32_t OwnSamples = 512;
  std::vector<Peak> found;
  const auto add = [&](const Point& point) {
    const Point at = within_rim(point);
    const double value = function(at.x, at.y);
    if (value > 0) found.push_back({at, value});
  };
  const Vec3f& u = function.plane_u();
  add({-u.x, 0});
  add({u.x, 0});
  for (int i = 0; i <= Thetas; ++i) {
    const double radius = std::sin(LimitDegrees * Degree * i / Thetas);
    for (int k = 0; k < Phis; ++k) {
      const double phi = 2 * std::numbers::pi * k / Phis;
      add(Point(std::cos(phi), std::sin(phi)) * radius);
    }
  }
  reflectance::SplitMix random = random_numbers(0);
  const reflectance::AzimuthRotation rotation(function.u());
  for (std::uint32_t i = 0; i < OwnSamples; ++i) {
    const reflectance::Uniforms xi = {random.next_pair(), random.next_pair().x};
    const auto sample = reflectance::own_sample(function.brdf(), function.u(), xi);
    if (!sample || !(sample->direction.z > 0)) continue;
    const Vec3f v = rotation.to_plane(sample->direction);
    add({v.x, v.y});
  }
  return found;
}

/// Climbs to a local maximum by a pattern search (Hooke and Jeeves 1961, "Direct search"): in eight
/// directions, with steps that are halved where none leads up.
Peak climbed(const DiscFunction& function, Peak peak) {
  constexpr double FirstStep = 0.03;
  constexpr double LastStep = 1e-7;  // the precision of a direction
  constexpr int MostMoves = 500;
  double step = FirstStep;
  for (int move = 0; move < MostMoves && step > LastStep; ++move) {
    Peak best = peak;
    for (const Point& way : {Point(1, 0), Point(0, 1), Point(-1, 0), Point(0, -1), Point(0.7, 0.7),
                             Point(-0.7, 0.7), Point(-0.7, -0.7), Point(0.7, -0.7)}) {
      const Point at = within_rim(peak.at + way * step);
      const double value = function(at.x, at.y);
      if (value > best.value) best = {at, value};
    }
    if (best.value > peak.value) {
      peak = best;
    } else {
      step /= 2;
    }
  }
  return peak;
}

/// A rectangle of angles: a point is at x = sin a, y = cos a sin b. The disc is a square of them, and f that
/// grows as 1 / sqrt(cos theta) at the horizon, as some do, is integrated without a singularity.
struct Cell {
  double a0, a1, b0, b1;

  double area() const { return (a1 - a0) * (b1 - b0); }
  Cell quarter(int index) const {
    const double a = (a0 + a1) / 2;
    const double b = (b0 + b1) / 2;
    return {index % 2 == 0 ? a0 : a, index % 2 == 0 ? a : a1, index < 2 ? b0 : b, index < 2 ? b : b1};
  }
  bool contains(const Point& at) const { return at.x >= a0 && at.x <= a1 && at.y >= b0 && at.y <= b1; }
};

/// Maps a point of the disc to x and the fraction of the half chord there, both from -1 to 1.
Point in_square(const Point& point) {
  const double chord = std::sqrt(std::max(0.0, 1 - point.x * point.x));
  return {std::clamp(point.x, -1.0, 1.0), chord > 0 ? std::clamp(point.y / chord, -1.0, 1.0) : 0};
}

/// Adaptive quadrature by the 3 x 3 Gauss-Legendre rule.
class Integrator {
 public:
  Integrator(const std::function<double(double, double)>& function, std::span<const Peak> peaks)
      : function_(function) {
    for (const Peak& peak : peaks) {
      const Point at = in_square(peak.at);
      peaks_.emplace_back(std::asin(at.x), std::asin(at.y));
    }
  }

  /// Returns the integrals over cells, each about as precise as the total.
  std::vector<double> over(const std::vector<Cell>& cells) {
    std::vector<double> sums;
    for (const Cell& cell : cells) sums.push_back(gauss(cell));
    total_ = std::accumulate(sums.begin(), sums.end(), 0.0);
    for (std::size_t i = 0; i < cells.size(); ++i) sums[i] = refined(cells[i], sums[i], 0);
    return sums;
  }

 private:
  double gauss(const Cell& cell) const {
    constexpr std::array<double, 3> Place = {-0.7745966692414834, 0, 0.7745966692414834};
    constexpr std::array<double, 3> Weight = {5.0 / 18, 8.0 / 18, 5.0 / 18};
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double a = (cell.a0 + cell.a1 + Place[i] * (cell.a1 - cell.a0)) / 2;
      const double chord = std::cos(a);
      for (std::size_t k = 0; k < 3; ++k) {
        const double b = (cell.b0 + cell.b1 + Place[k] * (cell.b1 - cell.b0)) / 2;
        const double jacobian = chord * chord * std::cos(b);
        sum += Weight[i] * Weight[k] * jacobian * function_(std::sin(a), chord * std::sin(b));
      }
    }
    return sum * cell.area();
  }

  double refined(const Cell& cell, double estimate, int depth) const {
    constexpr int Deepest = 12;
    constexpr int DeepestAtPeak = 6;
    std::array<double, 4> parts{};
    for (int i = 0; i < 4; ++i) parts[static_cast<std::size_t>(i)] = gauss(cell.quarter(i));
    const double sum = std::accumulate(parts.begin(), parts.end(), 0.0);
    const double tolerance = 2e-4 * std::abs(sum) + 1e-7 * total_;
    const bool is_at_peak = depth < DeepestAtPeak && std::ranges::any_of(peaks_, [&](const Point& peak) {
                              return cell.contains(peak);
                            });
    if (depth >= Deepest || (!is_at_peak && std::abs(sum - estimate) <= tolerance)) return sum;
    double total = 0;
    for (int i = 0; i < 4; ++i)
      total += refined(cell.quarter(i), parts[static_cast<std::size_t>(i)], depth + 1);
    return total;
  }

  const std::function<double(double, double)>& function_;
  std::vector<Point> peaks_;
  double total_ = 0;  ///< about
};

}  // namespace

DiscFunction::DiscFunction(const reflectance::Brdf& brdf, const Angles& view)
    : brdf_(brdf),
      azimuth_(static_cast<float>(std::cos(view.phi)), static_cast<float>(std::sin(view.phi))),
      rotation_(azimuth_.x, azimuth_.y),
      plane_u_(direction_of({view.theta, 0})) {
  u_ = rotation_.from_plane(plane_u_);
}

double DiscFunction::operator()(double x, double y) const {
  if (!(x * x + y * y < 1)) return 0;
  return reflectance::mean(reflectance::evaluate(brdf_, u_, direction({x, y})));
}

Vec3f DiscFunction::direction(const Point& point) const { return rotation_.from_plane(over(point)); }

std::vector<Peak> find_peaks(const DiscFunction& function) {
  constexpr std::size_t Climbs = 8;
  constexpr double Apart = 0.08;
  const auto is_larger = [](const Peak& a, const Peak& b) { return a.value > b.value; };
  std::vector<Peak> all = candidates(function);
  std::ranges::sort(all, is_larger);
  std::vector<Peak> peaks;
  for (const Peak& candidate : all) {
    if (peaks.size() == Climbs) break;
    if (std::ranges::all_of(peaks,
                            [&](const Peak& peak) { return (peak.at - candidate.at).length() > Apart; }))
      peaks.push_back(candidate);
  }
  for (Peak& peak : peaks) peak = climbed(function, peak);
  std::ranges::sort(peaks, is_larger);
  return peaks;
}

std::size_t DiscCells::cell_of(const Point& point) {
  const auto index = [](double coordinate, int count) {
    return static_cast<std::size_t>(std::clamp(static_cast<int>((coordinate + 1) / 2 * count), 0, count - 1));
  };
  const Point at = in_square(point);
  return index(at.x, Columns) * Rows + index(at.y, Rows);
}

DiscCells integrate(const std::function<double(double, double)>& function, std::span<const Peak> peaks) {
  const auto edge = [](int index, int count) { return std::asin(2.0 * index / count - 1); };
  std::vector<Cell> cells;
  for (int i = 0; i < DiscCells::Columns; ++i) {
    for (int k = 0; k < DiscCells::Rows; ++k)
      cells.push_back({edge(i, DiscCells::Columns), edge(i + 1, DiscCells::Columns), edge(k, DiscCells::Rows),
                       edge(k + 1, DiscCells::Rows)});
  }
  DiscCells result;
  result.masses = Integrator(function, peaks).over(cells);
  result.total = std::accumulate(result.masses.begin(), result.masses.end(), 0.0);
  return result;
}

double area_of(Region region) { return region == Region::Disc ? std::numbers::pi : 4; }

Run<Point> sample_disc(const DiscFunction& function, double bound, Region region, const RunLimits& limits,
                       std::uint32_t seed) {
  reflectance::SplitMix random = random_numbers(seed);
  const auto propose = [&](bool) {
    const double s = random.next();
    const double t = random.next();
    if (region == Region::Square) return Point(2 * s - 1, 2 * t - 1);
    return Point(std::cos(2 * std::numbers::pi * t), std::sin(2 * std::numbers::pi * t)) * std::sqrt(s);
  };
  const auto value = [&, limit2 = rim() * rim()](const Point& at) {
    return at.length2() < limit2 ? function(at.x, at.y) : 0;
  };
  return reject<Point>(
      limits, propose, [&] { return bound; }, value, [&] { return random.next(); });
}

DiscTree::DiscTree(const DiscFunction& function, int cells, double most_tries) : cells_(cells) {
  const DiscGrid grid(cells);
  const std::vector<float> values =
      reflectance::disc_values(function.brdf(), function.plane_u(), function.azimuth(), grid);
  largest_ = *std::ranges::max_element(values);
  tree_ = RejectionTree(values, grid, static_cast<float>(most_tries), true);
  double volume = 0;
  visit([&](const Leaf& leaf) {
    const reflectance::Box box = reflectance::inside_disc(DiscGrid::box(leaf.cells, cells_));
    // A leaf outside the disc has an empty box, and an area and integral of 0 up to rounding.
    if (!(leaf.node->integral > 0) || box.x0 >= box.x1 || box.y0 >= box.y1) return;
    ++leaves_;
    volume += box.area() * leaf.node->maximum;
  });
  if (volume > 0) acceptance_ = tree_.nodes().front().integral / volume;
}

void DiscTree::visit(const std::function<void(const Leaf& leaf)>& visit) const {
  std::vector<Leaf> open = {{tree_.nodes().data(), {0, 0, cells_, cells_}}};
  while (!open.empty()) {
    const Leaf leaf = open.back();
    open.pop_back();
    if (leaf.node->children < 0) {
      if (!leaf.cells.is_empty()) visit(leaf);
      continue;
    }
    for (int i = 0; i < 4; ++i)
      open.push_back(
          {&tree_.nodes()[static_cast<std::size_t>(leaf.node->children) + static_cast<std::size_t>(i)],
           leaf.cells.quarter(i)});
  }
}

void DiscTree::visit_leaves(const std::function<void(const reflectance::Box& box)>& visit_box) const {
  visit([&](const Leaf& leaf) { visit_box(DiscGrid::box(leaf.cells, cells_)); });
}

double DiscTree::bound_at(const Point& point) const {
  const int column = DiscGrid::cell_of(point.x, cells_);
  const int row = DiscGrid::cell_of(point.y, cells_);
  Leaf leaf = {tree_.nodes().data(), {0, 0, cells_, cells_}};
  while (leaf.node->children >= 0) {
    const auto children = static_cast<std::size_t>(leaf.node->children);
    for (int i = 0; i < 4; ++i) {
      const reflectance::CellRange part = leaf.cells.quarter(i);
      if (column < part.x0 || column >= part.x1 || row < part.y0 || row >= part.y1) continue;
      leaf = {&tree_.nodes()[children + static_cast<std::size_t>(i)], part};
      break;
    }
  }
  return leaf.node->maximum * largest_;
}

Run<Point> DiscTree::sample(const RunLimits& limits, std::uint32_t seed) const {
  reflectance::SplitMix random = random_numbers(seed);
  Run<Point> run;
  run.accepted.reserve(limits.samples);
  const auto start = std::chrono::steady_clock::now();
  while (run.accepted.size() < limits.samples && run.tries < RunLimits::MostTries) {
    if (run.accepted.size() % RunLimits::PollEvery == 0 && limits.is_stopped && limits.is_stopped()) break;
    const Leaf leaf = tree_.leaf_of(random.next());
    const auto drawn = tree_.draw(leaf, random.next_pair(), random, [&](double x, double y) {
      if (run.recorded.size() < RunLimits::MostRecorded) run.recorded.push_back({{x, y}, 0, false});
      return tree_.at(x, y);
    });
    run.tries += static_cast<std::size_t>(drawn ? drawn->tries : RejectionTree::Bound);
    if (!drawn) continue;
    run.accepted.emplace_back(drawn->x, drawn->y);
    // The last place that was recorded is the one accepted, unless there was no space for it.
    if (!run.recorded.empty() && run.recorded.back().place == run.accepted.back())
      run.recorded.back().is_accepted = true;
  }
  run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return run;
}

}  // namespace studies
