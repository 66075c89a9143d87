// Environment maps with a sun, black texels, and NaN or infinity in the file.
#include <cstring>
#include <limits>
#include <numbers>
#include <numeric>

#include "renderer/transport/integrators/power_heuristic.h"
#include "renderer/transport/lights/environment_map.h"
#include "renderer/transport/sobol.h"
#include "tests/stability/hard_case.h"
#include "tests/support/temporary_folder.h"
#include "tests/transport/environment_images.h"

namespace test {
namespace {

using grf::Vec2f;
using grf::Vec3f;
using image::Image;
using reflectance::Rgb;
using transport::EnvironmentMap;

double row_solid_angle(const Image& image, int y) {
  const double step = std::numbers::pi / image.height;
  return 2 * std::numbers::pi / image.width * (std::cos(step * y) - std::cos(step * (y + 1)));
}

/// Integrates by the midpoint rule, with so many points along each side of a texel.
double irradiance(const Image& image, const Vec3f& normal, int points) {
  double sum = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      double cosine = 0;
      for (int k = 0; k < points * points; ++k) {
        const auto direction =
            direction_at<double>(image, x + (k % points + 0.5) / points, y + (k / points + 0.5) / points);
        cosine += std::max(0.0, direction.dot(Imath::V3d(normal))) / (points * points);
      }
      sum += double(image.at(x, y).x) * cosine * row_solid_angle(image, y);
    }
  }
  return sum;
}

constexpr int SamplesOfMap = 4096;

/// Combines map sampling and cosine sampling by multiple importance sampling, as paths do.
double sampled_irradiance(const EnvironmentMap& map, const Vec3f& normal, std::uint32_t seed) {
  using transport::power_heuristic;
  const reflectance::Frame frame(normal);
  double sum = 0;
  for (int i = 0; i < SamplesOfMap; ++i) {
    const auto xi = transport::sobol_point(static_cast<std::uint32_t>(i), seed);
    if (const auto light = map.sample(normal, xi.xy())) {
      const float pdf = reflectance::cosine_pdf(frame.to_local(light->direction));
      const float weight = power_heuristic(light->pdf, pdf);
      sum += weight * pdf * reflectance::Pi / light->pdf * light->radiance.x;
    }
    const Vec3f local = reflectance::cosine_direction({xi.z, xi.w});
    const Vec3f direction = frame.to_world(local);
    const float weight = power_heuristic(reflectance::cosine_pdf(local), map.pdf(normal, direction));
    sum += weight * reflectance::Pi * map.radiance(direction).x;
  }
  return sum / SamplesOfMap;
}

double naive_irradiance(const EnvironmentMap& map, const Vec3f& normal, std::uint32_t seed) {
  const reflectance::Frame frame(normal);
  double sum = 0;
  for (int i = 0; i < SamplesOfMap; ++i) {
    const auto xi = transport::sobol_point(static_cast<std::uint32_t>(i), seed).xy();
    sum += map.radiance(frame.to_world(reflectance::cosine_direction(xi))).x;
  }
  return sum * std::numbers::pi / SamplesOfMap;
}

Errors sun() {
  const Image image = image_of(1024, 512, [](int x, int y) {
    return x == 700 && y == 150 ? 1e6F : y < 256 ? 1.0F : 0.1F;
  });
  const EnvironmentMap map(image);
  Errors errors;
  for (const Vec3f& normal : {Vec3f(0, 1, 0), Vec3f(0, 0, 1), Vec3f(0.6F, 0, 0.8F)}) {
    const double exact = irradiance(image, normal, 2);
    for (std::uint32_t seed = 0; seed < 8; ++seed) {
      errors.include({relative_error(sampled_irradiance(map, normal, seed), exact),
                      relative_error(naive_irradiance(map, normal, seed), exact)});
    }
  }
  return errors;
}

/// A naive table: one list of all texels' probabilities, summed in float and searched by bisection.
class NaiveTable {
 public:
  explicit NaiveTable(const Image& image) : width_(static_cast<std::size_t>(image.width)) {
    float sum = 0;
    for (int y = 0; y < image.height; ++y) {
      const float sine =
          std::sin(reflectance::Pi * (static_cast<float>(y) + 0.5F) / static_cast<float>(image.height));
      for (int x = 0; x < image.width; ++x) sums_.push_back(sum += image.at(x, y).x * sine);
    }
  }
  std::size_t row_of(float xi) const {
    const auto found = std::lower_bound(sums_.begin(), sums_.end(), xi * sums_.back());
    return static_cast<std::size_t>(found - sums_.begin()) / width_;
  }

 private:
  std::size_t width_;
  std::vector<float> sums_;
};

/// Tests the dim side of a map with a sun near the zenith: the fraction of samples near the nadir, within 10
/// degrees.
Errors ground_beside_a_sun() {
  constexpr std::uint32_t Draws = 1U << 20U;
  const Image image = image_of(2048, 1024, [](int x, int y) { return x == 700 && y == 400 ? 1e6F : 0.02F; });
  double exact = 0;
  double total = 0;
  constexpr int First = 1024 * 170 / 180;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const double power = double(image.at(x, y).x) * row_solid_angle(image, y);
      total += power;
      if (y >= First) exact += power;
    }
  }
  const EnvironmentMap map(image);
  const NaiveTable naive(image);
  std::uint32_t ours = 0;
  std::uint32_t by_naive = 0;
  for (std::uint32_t i = 0; i < Draws; ++i) {
    const Vec2f xi = transport::sobol_point(i, 1).xy();
    if (map.sample(xi)->direction.y < std::cos(std::numbers::pi * First / image.height)) ++ours;
    if (naive.row_of(xi.y) >= First) ++by_naive;
  }
  return {relative_error(ours / double(Draws), exact / total),
          relative_error(by_naive / double(Draws), exact / total)};
}

/// Naive code: each weight over the sum of all.
std::vector<float> naive_shares(const std::vector<float>& weights) {
  const float total = std::accumulate(weights.begin(), weights.end(), 0.0F);
  std::vector<float> shares;
  float sum = 0;
  for (const float weight : weights) shares.push_back(sum += weight / total);
  return shares;
}

/// Naive code: the first that is not below xi.
std::size_t naive_index(const std::vector<float>& shares, float xi) {
  const auto found = std::lower_bound(shares.begin(), shares.end(), xi);
  return std::min(static_cast<std::size_t>(found - shares.begin()), shares.size() - 1);
}

/// A naive list for the rows, and one for the columns of each; returns a texel's luminance over its pdf.
class NaiveRows {
 public:
  explicit NaiveRows(const Image& image) : image_(image) {
    std::vector<float> rows;
    for (int y = 0; y < image.height; ++y) {
      std::vector<float> row;
      for (int x = 0; x < image.width; ++x) row.push_back(image.at(x, y).x);
      rows.push_back(std::accumulate(row.begin(), row.end(), 0.0F));
      columns_.push_back(naive_shares(row));
    }
    total_ = std::accumulate(rows.begin(), rows.end(), 0.0F);
    rows_ = naive_shares(rows);
  }
  float weight(const Vec2f& xi) const {
    const std::size_t y = naive_index(rows_, xi.y);
    const std::size_t x = naive_index(columns_[y], xi.x);
    const float radiance = image_.at(static_cast<int>(x), static_cast<int>(y)).x;
    return radiance / (radiance / total_);
  }

 private:
  const Image& image_;
  std::vector<float> rows_;
  std::vector<std::vector<float>> columns_;
  float total_ = 0;
};

constexpr int Side = 64;

/// Returns pairs in which each number also takes both ends of [0,1).
std::vector<Vec2f> grid_with_ends() {
  const auto number = [](int i) { return std::min(static_cast<float>(i) / (Side - 1), 0x1.fffffep-1F); };
  std::vector<Vec2f> pairs;
  for (int i = 0; i < Side * Side; ++i) pairs.emplace_back(number(i % Side), number(i / Side));
  return pairs;
}

/// Returns the fraction of invalid draws: not finite, or in a black texel.
template <class Draw>
double share_of_wrong(Draw draw) {
  int wrong = 0;
  for (const Vec2f& xi : grid_with_ends()) {
    const float weight = draw(xi);
    if (!std::isfinite(weight) || weight <= 0) ++wrong;
  }
  return wrong / double(Side * Side);
}

Errors black_texels() {
  const Image image = image_of(
      64, 32, [](int x, int y) { return y % 3 == 1 && x > 5 && x < 60 && x % 2 == 0 ? 1.0F : 0.0F; });
  const EnvironmentMap map(image);
  const NaiveRows naive(image);
  const auto ours = [&](const Vec2f& xi) {
    const auto drawn = map.sample(xi);
    return drawn ? drawn->radiance.x / drawn->pdf : 0.0F;
  };
  return {share_of_wrong(ours), share_of_wrong([&](const Vec2f& xi) { return naive.weight(xi); })};
}

/// Formats a PFM file, whose rows start at the bottom.
std::string pfm_of(const Image& image) {
  std::string bytes = "PF\n" + std::to_string(image.width) + " " + std::to_string(image.height) + "\n-1.0\n";
  for (int y = image.height - 1; y >= 0; --y) {
    for (int x = 0; x < image.width; ++x) {
      const Rgb& texel = image.at(x, y);
      for (const float value : {texel.x, texel.y, texel.z}) {
        char raw[sizeof(value)];
        std::memcpy(raw, &value, sizeof(value));
        bytes.append(raw, sizeof(value));
      }
    }
  }
  return bytes;
}

/// Tests that three invalid texels count as black.
Errors texels_that_are_no_numbers() {
  const auto image_with = [](float nan, float infinity, float negative) {
    return image_of(64, 32, [=](int x, int y) {
      if (x == 3 && y == 5) return nan;
      if (x == 30 && y == 5) return infinity;
      if (x == 40 && y == 10) return negative;
      return 1 + static_cast<float>((x + y) % 3);
    });
  };
  const Image image = image_with(NAN, std::numeric_limits<float>::infinity(), -1e6F);
  const TemporaryFolder folder;
  grf::Diagnostics diagnostics;
  const auto map = transport::read_environment_map(folder.add("sky.pfm", pfm_of(image)), diagnostics);
  if (!map || map->invalid_texels() != 3) return {INFINITY, 0};
  const Vec3f normal(0, 1, 0);
  const double exact = irradiance(image_with(0, 0, 0), normal, 4);
  const NaiveRows naive(image);
  double by_naive = 0;
  for (const Vec2f& xi : grid_with_ends()) by_naive += double(naive.weight(xi)) / (Side * Side);
  Errors errors;
  for (std::uint32_t seed = 0; seed < 8; ++seed) {
    errors.include(
        {relative_error(sampled_irradiance(*map, normal, seed), exact), relative_error(by_naive, exact)});
  }
  return errors;
}

}  // namespace

std::vector<HardCase> environment_cases() {
  constexpr std::string_view Irradiance = "relative error of the irradiance of 4096 samples";
  return {
      {"Environment map with one texel of 1e6 (a sun)", "cosine sampling",
       "map sampling too, with multiple importance sampling", 0.9, 0.02, 3e-3, sun, Irradiance, Kind::Noisy},
      {"Dim ground of a map with a sun of 1e6", "one cdf of all texels, summed in float",
       "marginal and conditional cdfs, summed in double", 1, 0.02, 2e-3, ground_beside_a_sun,
       "relative error of the fraction of samples near the nadir", Kind::Noisy},
      {"Map with black texels and rows, random numbers 0 and 1 - 2^-24",
       "each row over its sum, which is 0/0; the first cdf value not below xi",
       "a black row is never chosen; the first cdf value above xi", 0.05, 0, 0, black_texels,
       "fraction of samples that are not finite or black"},
      {"Map with NaN, infinity and -1e6 in its file", "sums of the values as they are",
       "they count as 0, with a warning, before summing", INFINITY, 0.02, 8e-4, texels_that_are_no_numbers,
       Irradiance, Kind::Noisy},
  };
}

}  // namespace test
