#include "renderer/studies/environment/sampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "renderer/parallel/loops.h"
#include "renderer/plot/brdf_charts.h"
#include "renderer/studies/angles.h"
#include "renderer/transport/sobol.h"

namespace studies {
namespace {

using reflectance::mean;
using reflectance::Resampler;
using reflectance::Resampling;
using reflectance::Rgb;
using reflectance::Vec3f;

/// The part of an integral, as estimated before, above which a difference is worth a subdivision.
constexpr double Tolerance = 1e-5;
constexpr int DeepestLevel = 9;
/// Cells about the mirror direction are subdivided to this level in any case: the lobe may be so narrow that
/// no centre of a larger cell meets it.
constexpr int MirrorLevel = 5;

constexpr std::uint32_t PatternOfFigure = 0;
constexpr std::uint32_t PatternOfDeviations = 1;

double mean_of(const Imath::V3d& sum) { return (sum.x + sum.y + sum.z) / 3; }

/// Draws the candidates of one resampling and chooses from them, in the order of the path tracer.
template <class Use>
void add_candidates(const LitSurface& surface, int count, const transport::SampleSet& points,
                    Resampler& resampler, const Use& use) {
  // Resampling by 1 leaves the choice to the caller, who may want several of different sizes.
  const auto draw = [&](int j) {
    const transport::Uniform4 xi = points[j];
    auto sample = surface.reflector->sample(surface.u, {xi.xy(), xi.z});
    use(sample);
    return sample;
  };
  const auto radiance = [&](const Vec3f& v) { return surface.map().radiance(surface.frame.to_world(v)); };
  reflectance::resample(resampler, {count, 1}, 0, draw, radiance, [](const Vec3f&, const Rgb&) {});
}

}  // namespace

/// A cell of the grid, or a part of one.
struct SurfaceQuadrature::Cell {
  double x = 0;  ///< left, in cells of the grid
  double y = 0;  ///< top
  double size = 1;
  int level = 0;
  Rgb f_cos;  ///< at the centre
};

void SurfaceQuadrature::Sums::add(const Rgb& f_cos, const Rgb& radiance, double solid_angle) {
  albedo += Imath::V3d(f_cos) * solid_angle;
  reflected += Imath::V3d(f_cos * radiance) * solid_angle;
}

void SurfaceQuadrature::Sums::add(const Sums& other) {
  albedo += other.albedo;
  reflected += other.reflected;
}

/// Sums over the rows of the grid, on all cores, in fixed order.
template <class Row>
SurfaceQuadrature::Sums SurfaceQuadrature::sum_of_rows(const Row& row,
                                                       const std::function<bool()>& is_stopped) {
  std::vector<Sums> sums(static_cast<std::size_t>(Grid.height));
  parallel::for_each_index(Grid.height, [&](int y) {
    if (!is_stopped || !is_stopped()) sums[static_cast<std::size_t>(y)] = row(y);
  });
  Sums total;
  for (const Sums& one : sums) total.add(one);
  return total;
}

SurfaceQuadrature::SurfaceQuadrature(const LitSurface& surface, const std::function<bool()>& is_stopped)
    : surface_(surface),
      mirror_(surface.frame.to_world(reflectance::mirrored(surface.u))),
      cells_(Grid.size()) {
  const Sums coarse = sum_of_rows([this](int y) { return sample_row(y); }, is_stopped);
  albedo_scale_ = mean_of(coarse.albedo);
  reflected_scale_ = mean_of(coarse.reflected);
  const Sums sums = sum_of_rows([this](int y) { return integral_of_row(y); }, is_stopped);
  const double albedo = mean_of(sums.albedo);
  const double reflected = mean_of(sums.reflected);
  albedo_ = Rgb(sums.albedo);
  reflected_ = Rgb(sums.reflected);
  for (DirectionValues& cell : cells_) {
    cell.brdf = albedo > 0 ? mean(cell.f_cos) / albedo : 0;
    cell.product = reflected > 0 ? mean(cell.f_cos * cell.radiance) / reflected : 0;
  }
}

Rgb SurfaceQuadrature::f_cos(const Vec3f& direction) const {
  const Vec3f v = surface_.frame.to_local(direction);
  return v.z > 0 ? surface_.reflector->evaluate(surface_.u, v) * v.z : Rgb(0);
}

Rgb SurfaceQuadrature::fine_radiance(double x, double y) const {
  constexpr SphereGrid Fine = FilteredMap::Grid;
  const auto column = static_cast<std::size_t>(x * Fine.width / Grid.width);
  const auto row = static_cast<std::size_t>(y * Fine.height / Grid.height);
  return surface_.environment->cells[row * static_cast<std::size_t>(Fine.width) + column];
}

/// Evaluates the cells of a row, and returns the integrals by the midpoint rule.
SurfaceQuadrature::Sums SurfaceQuadrature::sample_row(int y) {
  constexpr int Parts = FilteredMap::Grid.width / Grid.width;
  static_assert(Parts == 2 && FilteredMap::Grid.height == Parts * Grid.height);
  const double total = surface_.map().total();
  const double whole = Grid.solid_angle(y, y + 1, 1);
  const auto upper = static_cast<float>(2 * Grid.solid_angle(y, y + 0.5, 0.5) / whole);
  Sums sums;
  for (int x = 0; x < Grid.width; ++x) {
    DirectionValues& cell = cells_[static_cast<std::size_t>(y) * static_cast<std::size_t>(Grid.width) +
                                   static_cast<std::size_t>(x)];
    const Vec3f direction = Grid.direction(x + 0.5, y + 0.5);
    cell.radiance = (fine_radiance(x, y) + fine_radiance(x + 0.5, y)) * (upper / 2) +
                    (fine_radiance(x, y + 0.5) + fine_radiance(x + 0.5, y + 0.5)) * ((1 - upper) / 2);
    cell.map = plot::channel_of(cell.radiance, plot::Channel::Luminance) / total;
    cell.warps = surface_.map().pdf(surface_.frame.z, direction);
    cell.f_cos = f_cos(direction);
    const Vec3f v = surface_.frame.to_local(direction);
    if (v.z > 0) cell.scheme = surface_.reflector->pdf(surface_.u, v);
    sums.add(cell.f_cos, cell.radiance, whole);
  }
  return sums;
}

double SurfaceQuadrature::importance(const Rgb& difference, const Rgb& radiance, double solid_angle) const {
  const Rgb size(std::abs(difference.x), std::abs(difference.y), std::abs(difference.z));
  const double of_albedo = albedo_scale_ > 0 ? mean(size) * solid_angle / albedo_scale_ : 0;
  const double of_light = reflected_scale_ > 0 ? mean(size * radiance) * solid_angle / reflected_scale_ : 0;
  return std::max(of_albedo, of_light);
}

/// Returns whether f cos differs from that of a neighbour by more than the tolerance.
bool SurfaceQuadrature::varies(int x, int y) const {
  const auto at = [&](int column, int row) -> const DirectionValues& {
    const int wrapped = (column + Grid.width) % Grid.width;
    return cells_[static_cast<std::size_t>(std::clamp(row, 0, Grid.height - 1)) *
                      static_cast<std::size_t>(Grid.width) +
                  static_cast<std::size_t>(wrapped)];
  };
  const DirectionValues& here = at(x, y);
  const double solid_angle = Grid.solid_angle(y, y + 1, 1);
  const std::array neighbours = {&at(x - 1, y), &at(x + 1, y), &at(x, y - 1), &at(x, y + 1)};
  return std::ranges::any_of(neighbours, [&](const DirectionValues* other) {
    return importance(here.f_cos - other->f_cos, here.radiance, solid_angle) > Tolerance;
  });
}

SurfaceQuadrature::Sums SurfaceQuadrature::integral_of_row(int y) const {
  Sums sums;
  for (int x = 0; x < Grid.width; ++x) {
    const DirectionValues& cell = cells_[static_cast<std::size_t>(y) * static_cast<std::size_t>(Grid.width) +
                                         static_cast<std::size_t>(x)];
    if (is_near_mirror(Grid.direction(x + 0.5, y + 0.5), 1) || varies(x, y))
      subdivide({double(x), double(y), 1, 0, cell.f_cos}, sums);
    else
      sums.add(cell.f_cos, cell.radiance, Grid.solid_angle(y, y + 1, 1));
  }
  return sums;
}

/// Returns whether a cell is within two of its heights from the mirror direction.
bool SurfaceQuadrature::is_near_mirror(const Vec3f& centre, double size) const {
  return double((centre - mirror_).length()) < 2 * size * std::numbers::pi / Grid.height;
}

/// Adds the integrals over the four parts of a cell, each of which may be subdivided further.
void SurfaceQuadrature::subdivide(const Cell& cell, Sums& sums) const {
  const double half = cell.size / 2;
  for (int k = 0; k < 4; ++k) {
    Cell part = cell;
    part.x += (k % 2) * half;
    part.y += (k / 2) * half;
    part.size = half;
    ++part.level;
    const Vec3f centre = Grid.direction(part.x + half / 2, part.y + half / 2);
    part.f_cos = f_cos(centre);
    const Rgb radiance = fine_radiance(part.x, part.y);
    const double solid_angle = Grid.solid_angle(part.y, part.y + half, half);
    const bool goes_on =
        (part.level < MirrorLevel && is_near_mirror(centre, half)) ||
        (part.level < DeepestLevel && importance(part.f_cos - cell.f_cos, radiance, solid_angle) > Tolerance);
    if (goes_on)
      subdivide(part, sums);
    else
      sums.add(part.f_cos, radiance, solid_angle);
  }
}

DirectionValues SurfaceQuadrature::at(const Vec3f& direction) const {
  const transport::EnvironmentMap& map = surface_.map();
  const auto [radiance, warps] = map.radiance_and_pdf(surface_.frame.z, direction);
  DirectionValues values;
  values.radiance = radiance;
  values.f_cos = f_cos(direction);
  values.map = map.pdf(direction);
  values.warps = warps;
  const double albedo = mean(albedo_);
  const double reflected = mean(reflected_);
  values.brdf = albedo > 0 ? mean(values.f_cos) / albedo : 0;
  values.product = reflected > 0 ? mean(values.f_cos * radiance) / reflected : 0;
  const Vec3f v = surface_.frame.to_local(direction);
  if (v.z > 0) values.scheme = surface_.reflector->pdf(surface_.u, v);
  return values;
}

double SurfaceQuadrature::missed_light(double factor) const {
  double missed = 0;
  double all = 0;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const int y = static_cast<int>(i) / Grid.width;
    const double light = cells_[i].product * Grid.solid_angle(y, y + 1, 1);
    all += light;
    if (cells_[i].product > factor * cells_[i].scheme) missed += light;
  }
  return all > 0 ? missed / all : 0;
}

double SurfaceQuadrature::expected_efficiency() const {
  double sum = 0;
  for (int y = 0; y < Grid.height; ++y) {
    const double solid_angle = Grid.solid_angle(y, y + 1, 1);
    for (int x = 0; x < Grid.width; ++x) {
      const DirectionValues& cell =
          cells_[static_cast<std::size_t>(y) * static_cast<std::size_t>(Grid.width) +
                 static_cast<std::size_t>(x)];
      if (!(cell.product > 0)) continue;
      if (!(cell.scheme > 0)) return 0;
      sum += cell.product * cell.product / cell.scheme * solid_angle;
    }
  }
  return sum > 0 ? 1 / sum : 0;
}

double ResampledLight::effective_candidates() const {
  double sum = 0;
  double squares = 0;
  for (const Candidate& candidate : candidates) {
    sum += candidate.weight();
    squares += candidate.weight() * candidate.weight();
  }
  return squares > 0 ? sum * sum / squares : 0;
}

double ResampledLight::largest_weight() const {
  double sum = 0;
  double largest = 0;
  for (const Candidate& candidate : candidates) {
    sum += candidate.weight();
    largest = std::max(largest, candidate.weight());
  }
  return sum > 0 ? largest * static_cast<double>(candidates.size()) / sum : 0;
}

std::size_t ResampledLight::rejected() const {
  return static_cast<std::size_t>(std::ranges::count_if(
      candidates, [](const Candidate& candidate) { return !(candidate.weight() > 0); }));
}

ResampledLight resample(const LitSurface& surface, const Resampling& counts, std::uint32_t seed) {
  transport::PathSampler sampler(transport::hash(seed, PatternOfFigure), 0);
  const float xi = sampler.next().x;
  const transport::SampleSet points = sampler.next_set(counts.candidates);
  ResampledLight light;
  double sum = 0;
  Resampler resampler;
  add_candidates(
      surface, counts.candidates, points, resampler,
      [&](const std::optional<reflectance::ScatterSample>& sample) {
        Candidate candidate = {Vec3f(0, 0, 1), Rgb(0)};
        if (sample) {
          const Rgb radiance = surface.map().radiance(surface.frame.to_world(sample->direction));
          candidate = {sample->direction, sample->weight * radiance, sample->pdf, sample->is_specular, 0};
        }
        sum += candidate.weight();
        light.candidates.push_back(candidate);
      });
  // The chosen ones come in the order of the candidates, with the number of copies in their estimates.
  const double step = sum / counts.candidates / counts.chosen;
  auto candidate = light.candidates.begin();
  resampler.choose(counts.chosen, xi, [&](const Vec3f& v, const Rgb& estimate) {
    while (candidate->v != v || !(candidate->weight() > 0)) ++candidate;
    candidate->copies = static_cast<int>(std::lround(mean(estimate) / step));
    ++candidate;
    light.estimate += estimate;
  });
  return light;
}

std::vector<Deviation> measure_deviations(const LitSurface& surface, const Visibility& is_visible,
                                          const DeviationPlan& plan, std::uint32_t seed,
                                          const std::function<bool()>& is_stopped) {
  std::vector<Deviation> deviations;
  Resampler resampler;
  for (const int count : plan.candidates) {
    const auto end = std::ranges::upper_bound(plan.chosen, count);
    const std::vector<int> chosen(plan.chosen.begin(), end);
    const int repetitions = std::max(plan.least_repetitions, plan.least_total / count);
    std::vector<double> sums(chosen.size());
    std::vector<double> squares(chosen.size());
    for (int r = 0; r < repetitions; ++r) {
      if (is_stopped && is_stopped()) return deviations;
      transport::PathSampler sampler(transport::hash(seed, PatternOfDeviations),
                                     static_cast<std::uint32_t>(r));
      const float xi = sampler.next().x;
      add_candidates(surface, count, sampler.next_set(count), resampler, [](const auto&) {});
      for (std::size_t k = 0; k < chosen.size(); ++k) {
        double estimate = 0;
        resampler.choose(chosen[k], xi, [&](const Vec3f& v, const Rgb& part) {
          if (is_visible(v)) estimate += mean(part);
        });
        sums[k] += estimate;
        squares[k] += estimate * estimate;
      }
    }
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      const double average = sums[k] / repetitions;
      const double variance =
          (squares[k] / repetitions - average * average) * repetitions / (repetitions - 1);
      deviations.push_back(
          {{count, chosen[k]}, average > 0 ? std::sqrt(std::max(0.0, variance)) / average : 0});
    }
  }
  return deviations;
}

}  // namespace studies
