#include "renderer/transport/noise.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <utility>

#include "renderer/image/image_error.h"
#include "renderer/parallel/loops.h"
#include "renderer/transport/processor_clock.h"

namespace transport {
namespace {

using grf::Vec3d;

/// Noise and light of the parts of one list, in no unit.
struct Sums {
  std::vector<double> noise, light;

  explicit Sums(std::size_t parts) : noise(parts), light(parts) {}
  void operator+=(const Sums& other) {
    for (std::size_t i = 0; i < noise.size(); ++i) {
      noise[i] += other.noise[i];
      light[i] += other.light[i];
    }
  }
};

/// The radiance of one part of a pixel, in each of several images.
using Images = std::vector<Vec3d>;

/// The parts of a pixel that are not black.
class PixelParts {
 public:
  explicit PixelParts(std::size_t images) : images_(images) {}

  void add(std::size_t image, std::uint32_t part, const Vec3d& radiance) {
    parts_.try_emplace(part, images_, Vec3d(0)).first->second[image] += radiance;
  }

  void add_to(Sums& sums, const Images& total, const Vec3d& mean) const {
    for (const auto& [part, images] : parts_) {
      Vec3d part_mean(0);
      for (const Vec3d& image : images) part_mean += image / static_cast<double>(images_);
      for (int channel = 0; channel < 3; ++channel) {
        double covariance = 0;
        for (std::size_t i = 0; i < images_; ++i) {
          covariance += (images[i][channel] - part_mean[channel]) * (total[i][channel] - mean[channel]);
        }
        covariance /= static_cast<double>(images_ - 1);
        sums.noise[part] += covariance / (mean[channel] * mean[channel] + image::RelmseFloor);
        sums.light[part] +=
            part_mean[channel] / std::sqrt(mean[channel] * mean[channel] + image::RelmseFloor);
      }
    }
  }

 private:
  std::size_t images_;
  std::unordered_map<std::uint32_t, Images> parts_;
};

/// The three lists of parts, over a row of pixels.
struct RowSums {
  Sums lamps, bounces, reflectors;

  void operator+=(const RowSums& other) {
    lamps += other.lamps;
    bounces += other.bounces;
    reflectors += other.reflectors;
  }
};

class NoiseSearch {
 public:
  NoiseSearch(const CompiledScene& scene, const RenderSettings& settings, const NoiseSettings& noise)
      : scene_(scene), noise_(noise), settings_(settings), render_(scene, settings) {
    for (std::size_t i = 0; i < scene.geometry().lamps.size(); ++i) {
      const std::uint32_t end = i + 1 < scene.geometry().lamps.size()
                                    ? scene.geometry().lamps[i + 1].first_emitter
                                    : static_cast<std::uint32_t>(scene.lights().size());
      lamp_of_emitter_.resize(end, static_cast<std::uint32_t>(i));
    }
  }

  RowSums empty_sums() const {
    return {Sums(scene_.geometry().lamps.size() + 1),
            Sums(static_cast<std::size_t>(settings_.integrator.depth) + 1), Sums(reflector_count() + 1)};
  }

  RowSums row(int y) const {
    RowSums sums = empty_sums();
    for (int x = 0; x < settings_.width; ++x) add_pixel(x, y, sums);
    return sums;
  }

  double values() const { return 3.0 * settings_.width * settings_.height; }

 private:
  std::size_t reflector_count() const { return scene_.tables().size(); }

  void add_pixel(int x, int y, RowSums& sums) const {
    const auto images = static_cast<std::size_t>(noise_.images);
    PixelParts lamps(images);
    PixelParts bounces(images);
    PixelParts reflectors(images);
    Images total(images, Vec3d(0));
    Vec3d mean(0);
    std::vector<Contribution> contributions;
    for (std::size_t image = 0; image < images; ++image) {
      contributions.clear();
      for (int number = 0; number < noise_.samples; ++number) {
        render_.contributions_of(x, y, static_cast<int>(image), static_cast<std::uint32_t>(number),
                                 contributions);
      }
      for (const Contribution& contribution : contributions) {
        if (!is_finite(contribution.radiance)) continue;
        const Vec3d radiance = Vec3d(contribution.radiance) / static_cast<double>(noise_.samples);
        total[image] += radiance;
        lamps.add(image, lamp_of(contribution.emitter), radiance);
        bounces.add(image, static_cast<std::uint32_t>(contribution.bounces), radiance);
        reflectors.add(image, std::min(contribution.reflector, static_cast<std::uint32_t>(reflector_count())),
                       radiance);
      }
      mean += total[image] / static_cast<double>(images);
    }
    lamps.add_to(sums.lamps, total, mean);
    bounces.add_to(sums.bounces, total, mean);
    reflectors.add_to(sums.reflectors, total, mean);
  }

  std::uint32_t lamp_of(std::uint32_t emitter) const {
    return emitter == InvalidIndex ? static_cast<std::uint32_t>(scene_.geometry().lamps.size())
                                   : lamp_of_emitter_[emitter];
  }

  const CompiledScene& scene_;
  const NoiseSettings noise_;
  const RenderSettings settings_;
  const Render render_;
  std::vector<std::uint32_t> lamp_of_emitter_;
};

double sum_of(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum;
}

std::vector<NoiseShare> shares_of(const Sums& sums) {
  const double noise = sum_of(sums.noise);
  const double light = sum_of(sums.light);
  std::vector<NoiseShare> shares;
  for (std::size_t i = 0; i < sums.noise.size(); ++i) {
    if (sums.light[i] == 0) continue;
    shares.push_back({static_cast<std::uint32_t>(i), sums.noise[i] / noise, sums.light[i] / light});
  }
  std::stable_sort(shares.begin(), shares.end(),
                   [](const NoiseShare& a, const NoiseShare& b) { return a.noise > b.noise; });
  return shares;
}

/// The variance of a row's pixels, relative to their radiance, from independent images.
double row_variance(const std::vector<image::Image>& images, int y) {
  const auto count = static_cast<double>(images.size());
  double sum = 0;
  for (int x = 0; x < images.front().width; ++x) {
    for (int channel = 0; channel < 3; ++channel) {
      double mean = 0;
      for (const image::Image& image : images) mean += double(image.at(x, y)[channel]) / count;
      double squares = 0;
      for (const image::Image& image : images) {
        const double difference = double(image.at(x, y)[channel]) - mean;
        squares += difference * difference;
      }
      sum += squares / (count - 1) / (mean * mean + image::RelmseFloor);
    }
  }
  return sum / (3.0 * images.front().width);
}

/// Returns the ratio of two sums over the same units, and its standard error relative to itself.
std::pair<double, double> ratio_of_sums(const std::vector<double>& above, const std::vector<double>& below) {
  const double sum = sum_of(below);
  const double ratio = sum_of(above) / sum;
  double squares = 0;
  for (std::size_t i = 0; i < below.size(); ++i) {
    const double off = above[i] - ratio * below[i];
    squares += off * off;
  }
  const auto count = static_cast<double>(below.size());
  if (count < 2 || !(ratio > 0)) return {ratio, 0};
  return {ratio, std::sqrt(squares * count / (count - 1)) / sum / ratio};
}

MeasuredRatio with_interval(double ratio, double relative_error) {
  constexpr double NormalQuantile = 1.96;
  const double factor = std::exp(NormalQuantile * relative_error);
  return {ratio, ratio / factor, ratio * factor};
}

}  // namespace

std::optional<NoiseShares> noise_shares(const CompiledScene& scene, const RenderSettings& settings,
                                        const NoiseSettings& noise, const std::atomic<bool>& stopped) {
  RenderSettings plain = settings;
  plain.adaptive = false;
  plain.samples = noise.samples;
  const NoiseSearch search(scene, plain, noise);
  std::vector<RowSums> rows(static_cast<std::size_t>(plain.height), search.empty_sums());
  parallel::run_with_threads(plain.threads, [&] {
    parallel::for_each_index(plain.height, [&](int y) {
      if (!stopped) rows[static_cast<std::size_t>(y)] = search.row(y);
    });
  });
  if (stopped) return std::nullopt;
  RowSums sums = search.empty_sums();
  for (const RowSums& row : rows) sums += row;
  const double variance = sum_of(sums.lamps.noise) / search.values();
  if (!(variance > 0)) return std::nullopt;
  return NoiseShares{std::sqrt(variance), noise.samples, shares_of(sums.lamps), shares_of(sums.bounces),
                     shares_of(sums.reflectors)};
}

namespace {

/// Renders an image, and adds the processor time that it takes.
image::Image timed_image(const CompiledScene& scene, const RenderSettings& settings, int number,
                         double& seconds) {
  RenderSettings of_image = settings;
  of_image.seed += static_cast<std::uint32_t>(number);
  Render render(scene, of_image);
  const double start = process_seconds();
  render.run();
  seconds += process_seconds() - start;
  return render.film().mean();
}

}  // namespace

double seconds_of_image(const CompiledScene& scene, const RenderSettings& settings, int image) {
  double seconds = 0;
  timed_image(scene, settings, image, seconds);
  return seconds;
}

std::optional<MeasuredNoise> measure_noise(const CompiledScene& scene, const RenderSettings& settings,
                                           int images, const std::atomic<bool>& stopped,
                                           const std::function<void(int)>& after_image) {
  std::vector<image::Image> means;
  MeasuredNoise measured;
  for (int i = 0; i < images; ++i) {
    if (stopped) return std::nullopt;
    measured.seconds_of_images.push_back(0);
    means.push_back(timed_image(scene, settings, i, measured.seconds_of_images.back()));
    after_image(i);
  }
  double sum = 0;
  for (int y = 0; y < means.front().height; ++y) {
    measured.row_variances.push_back(row_variance(means, y));
    sum += measured.row_variances.back();
  }
  measured.error = std::sqrt(sum / means.front().height);
  return measured.error > 0 ? std::optional(measured) : std::nullopt;
}

double MeasuredNoise::seconds() const {
  return sum_of(seconds_of_images) / static_cast<double>(seconds_of_images.size());
}

NoiseRatios ratios_of(const MeasuredNoise& before, const MeasuredNoise& after) {
  const auto variance = ratio_of_sums(after.row_variances, before.row_variances);
  const auto time = ratio_of_sums(after.seconds_of_images, before.seconds_of_images);
  NoiseRatios ratios;
  ratios.variance = with_interval(variance.first, variance.second);
  ratios.time = with_interval(time.first, time.second);
  ratios.cost = with_interval(variance.first * time.first, std::hypot(variance.second, time.second));
  return ratios;
}

}  // namespace transport
