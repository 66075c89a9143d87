#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "renderer/image/image_error.h"
#include "tests/transport/error_scenes.h"

namespace test {

/// A comparison of estimated and true errors over some renders.
struct ErrorStudy {
  int runs = 0;
  int inside = 0;                 ///< true errors within their interval
  int above = 0;                  ///< true errors above it
  double quotients = 0;           ///< sum of estimated over true error
  double widths = 0;              ///< sum of the upper over the lower bound of intervals
  double stated = 0, actual = 0;  ///< sums of squared errors, relative to their scene's mean one
  int stopped = 0;                ///< renders with a target error
  int missed = 0;                 ///< of which the true error exceeded the target by more than the margin

  ErrorStudy& operator+=(const ErrorStudy& other) {
    runs += other.runs;
    inside += other.inside;
    above += other.above;
    quotients += other.quotients;
    widths += other.widths;
    stated += other.stated;
    actual += other.actual;
    stopped += other.stopped;
    missed += other.missed;
    return *this;
  }
  double coverage() const { return static_cast<double>(inside) / runs; }
  double mean_quotient() const { return quotients / runs; }
  double mean_width() const { return widths / runs; }
  double stated_over_true() const { return std::sqrt(stated / actual); }
  double missed_fraction() const { return static_cast<double>(missed) / stopped; }
};

/// Images with different seeds; the truth for one is the mean of all others.
class SeedImages {
 public:
  explicit SeedImages(const image::Image& first) : sum_(first.pixels.size(), Imath::V3d(0)), size_(first) {}

  void add(const image::Image& image) {
    for (std::size_t i = 0; i < sum_.size(); ++i) sum_[i] += Imath::V3d(image.pixels[i]);
    ++count_;
  }

  /// The squared error of an image against the mean of the others. The expected squared error of that mean, a
  /// fraction `share` of the image's own, is subtracted.
  double relmse(const image::Image& image, bool is_one_of_them, double share) const {
    image::Image truth = size_;
    const double others = count_ - (is_one_of_them ? 1 : 0);
    for (std::size_t i = 0; i < sum_.size(); ++i) {
      const Imath::V3d own = is_one_of_them ? Imath::V3d(image.pixels[i]) : Imath::V3d(0);
      truth.pixels[i] = transport::Rgb((sum_[i] - own) / others);
    }
    return image::error_of(image, truth).relmse / (1 + share / others);
  }

 private:
  std::vector<Imath::V3d> sum_;
  image::Image size_;
  int count_ = 0;
};

/// Statistics of one scene's renders with different seeds.
struct StudiedScene {
  SeedImages images;
  double squared_error = 0;  ///< mean over renders
};

/// Compares the estimated with the true errors of renders of one scene with this many seeds.
inline StudiedScene study_intervals(const SampleScene& scene, int seeds, int samples, ErrorStudy& study) {
  transport::RenderSettings settings = scene.settings;
  settings.samples = samples;
  std::vector<image::Image> images;
  std::vector<transport::ErrorEstimate> estimates;
  for (int seed = 0; seed < seeds; ++seed) {
    settings.seed = static_cast<std::uint32_t>(seed);
    transport::Render render(scene.scene, settings);
    render.run();
    images.push_back(render.film().mean());
    estimates.push_back(*render.film().error_estimate());
  }
  SeedImages all(images.front());
  for (const image::Image& image : images) all.add(image);
  double stated = 0;
  double mean = 0;
  for (std::size_t i = 0; i < images.size(); ++i) {
    const double squared = all.relmse(images[i], true, 1);
    const double error = std::sqrt(squared);
    study.inside += error >= estimates[i].low && error <= estimates[i].high ? 1 : 0;
    study.above += error > estimates[i].high ? 1 : 0;
    // An image that is exact, with an estimate that says so, is perfect.
    const bool is_exact = error == 0 && estimates[i].high == 0;
    study.quotients += is_exact ? 1 : estimates[i].error / error;
    study.widths += is_exact ? 1 : estimates[i].high / estimates[i].low;
    mean += squared / seeds;
    stated += estimates[i].error * estimates[i].error;
  }
  study.runs += seeds;
  study.stated += stated / mean;
  study.actual += seeds;
  return {std::move(all), mean};
}

/// Studies one scene with this many seeds: renders of `samples` per pixel whose error is estimated, and as
/// many that stop at a target of two thirds of their mean error.
inline void study_errors(const SampleScene& scene, int seeds, int samples, ErrorStudy& study) {
  const StudiedScene studied = study_intervals(scene, seeds, samples, study);
  transport::RenderSettings settings = scene.settings;
  settings.samples = transport::RenderSettings::Unlimited;
  settings.target_error = std::sqrt(studied.squared_error) * 2 / 3;
  settings.adaptive = true;
  for (int seed = 0; seed < seeds; ++seed) {
    settings.seed = static_cast<std::uint32_t>(1'000'000 + seed);
    transport::Render render(scene.scene, settings);
    render.run();
    const double share = render.samples_per_pixel() / samples;
    const double error = std::sqrt(studied.images.relmse(render.film().mean(), false, share));
    ++study.stopped;
    study.missed += error > transport::RenderSettings::ErrorMargin * *settings.target_error ? 1 : 0;
  }
}

/// Block means over renders with different seeds, and their variances.
struct BlockMeans {
  static constexpr int Side = 8;
  std::vector<double> means;
  std::vector<double> variances;  ///< of the means
};

inline BlockMeans block_means(const SampleScene& scene, const transport::RenderSettings& base, int renders) {
  transport::RenderSettings settings = base;
  const int across = settings.width / BlockMeans::Side;
  const int down = settings.height / BlockMeans::Side;
  const std::size_t blocks =
      static_cast<std::size_t>(3) * static_cast<std::size_t>(across) * static_cast<std::size_t>(down);
  std::vector<double> sums(blocks);
  std::vector<double> squares(blocks);
  for (int i = 0; i < renders; ++i, ++settings.seed) {
    transport::Render render(scene.scene, settings);
    render.run();
    const image::Image image = render.film().mean();
    std::vector<double> values(blocks);
    for (int y = 0; y < down * BlockMeans::Side; ++y) {
      for (int x = 0; x < across * BlockMeans::Side; ++x) {
        const auto row = static_cast<std::size_t>(y / BlockMeans::Side);
        const auto column = static_cast<std::size_t>(x / BlockMeans::Side);
        const std::size_t first = 3 * (row * static_cast<std::size_t>(across) + column);
        for (int k = 0; k < 3; ++k) values[first + static_cast<std::size_t>(k)] += image.at(x, y)[k];
      }
    }
    for (std::size_t b = 0; b < blocks; ++b) {
      sums[b] += values[b];
      squares[b] += values[b] * values[b];
    }
  }
  BlockMeans result;
  for (std::size_t b = 0; b < blocks; ++b) {
    const double mean = sums[b] / renders;
    result.means.push_back(mean);
    result.variances.push_back(std::max(0.0, squares[b] / renders - mean * mean) / (renders - 1));
  }
  return result;
}

/// The largest deviation of a block, in standard deviations: of adaptive renders against uniform ones.
inline double largest_difference(const SampleScene& scene, int samples, int renders) {
  transport::RenderSettings settings = scene.settings;
  settings.samples = samples;
  const BlockMeans uniform = block_means(scene, settings, renders);
  settings.seed = 1'000'000;
  settings.adaptive = true;
  const BlockMeans adaptive = block_means(scene, settings, renders);
  double largest = 0;
  for (std::size_t b = 0; b < uniform.means.size(); ++b) {
    const double deviation = std::sqrt(uniform.variances[b] + adaptive.variances[b]);
    if (!(deviation > 0)) continue;
    largest = std::max(largest, std::abs(uniform.means[b] - adaptive.means[b]) / deviation);
  }
  return largest;
}

}  // namespace test
