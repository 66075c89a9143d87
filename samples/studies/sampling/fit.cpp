#include "samples/studies/sampling/fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "renderer/parallel/loops.h"
#include "renderer/reflectance/schemes/view_square.h"
#include "samples/studies/sampling/lighting.h"

namespace study {
namespace {

using reflectance::mean;
using reflectance::Vec3f;

constexpr int Resolution = 160;  // of the square that the hemisphere is mapped to, along an edge
constexpr double SolidAngleOfCell = 2 * std::numbers::pi / (Resolution * Resolution);

Vec3f point_at(std::size_t i) {
  const auto coordinate = [](std::size_t index) {
    return (2 * static_cast<float>(index) + 1) / Resolution - 1;
  };
  return reflectance::from_square(coordinate(i % Resolution), coordinate(i / Resolution));
}

}  // namespace

FitMeter::FitMeter(const reflectance::Brdf& brdf) {
  for (const float degrees : ViewDegrees) {
    ViewValues values{in_plane_of_views(degrees), {}};
    double sum = 0;
    for (std::size_t i = 0; i < Resolution * Resolution; ++i) {
      const Vec3f v = point_at(i);
      values.shares.push_back(mean(evaluate(brdf, values.u, v)) * v.z);
      sum += values.shares.back() * SolidAngleOfCell;
    }
    for (float& share : values.shares) share /= static_cast<float>(sum);
    views_.push_back(std::move(values));
  }
}

Fit FitMeter::fit_of(const Technique& technique) const {
  Fit fit;
  for (const ViewValues& view : views_) {
    double difference = 0;
    double square = 0;
    for (std::size_t i = 0; i < view.shares.size(); ++i) {
      const double share = view.shares[i];
      const double pdf = technique.pdf(view.u, point_at(i));
      difference += std::abs(pdf - share) * SolidAngleOfCell;
      if (share > 0) square += share * share / pdf * SolidAngleOfCell;
    }
    fit.distance += difference / 2 / static_cast<double>(views_.size());
    fit.deviation += std::sqrt(std::max(0.0, square - 1)) / static_cast<double>(views_.size());
  }
  return fit;
}

double best_exponent(const std::string& scheme, const reflectance::Brdf& brdf, const FitMeter& meter) {
  double best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (const int exponent : {1, 2, 5, 10, 20, 50, 100, 200, 500, 1000}) {
    const Technique technique(brdf, scheme_of(fmt::format("{} exp={}", scheme, exponent)));
    const double deviation = meter.fit_of(technique).deviation;
    if (deviation < least) best = exponent;
    least = std::min(least, deviation);
  }
  return best;
}

FactorFit best_factors(const reflectance::Brdf& brdf, const FitMeter& meter, int most_factors) {
  std::vector<FactorFit> candidates;
  std::vector<std::size_t> bytes;
  for (const auto& [rows, columns] : {std::pair(32, 16), std::pair(100, 32), std::pair(200, 32)}) {
    for (const bool half : {false, true}) {
      for (int j = 1; j <= most_factors; ++j) {
        for (int k = 1; k <= most_factors; ++k) candidates.push_back({{rows, columns, j, k, half}, 0});
      }
    }
  }
  bytes.resize(candidates.size());
  parallel::for_each_index(candidates.size(), [&](std::size_t i) {
    const Technique technique(brdf, scheme_of(scheme_text(candidates[i].parameters)));
    candidates[i].distance = meter.fit_of(technique).distance;
    bytes[i] = technique.bytes();
  });
  double least = std::numeric_limits<double>::infinity();
  for (const FactorFit& one : candidates) least = std::min(least, one.distance);
  std::size_t best = 0;
  for (std::size_t i = 1; i < candidates.size(); ++i) {
    const bool is_near = candidates[i].distance <= 1.02 * least;
    const bool best_is_near = candidates[best].distance <= 1.02 * least;
    if (is_near && (!best_is_near || bytes[i] < bytes[best])) best = i;
  }
  return candidates[best];
}

}  // namespace study
