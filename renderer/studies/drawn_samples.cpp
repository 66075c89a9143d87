#include "renderer/studies/drawn_samples.h"

#include <algorithm>
#include <chrono>

namespace studies {

DrawnSamples draw_samples(const reflectance::Reflector& reflector, const reflectance::Vec3f& u,
                          std::uint32_t count, std::uint32_t seed, transport::SamplePattern pattern) {
  // Random numbers are made before the clock starts.
  std::vector<reflectance::Uniforms> points;
  points.reserve(count);
  const transport::SampleSet set(0, transport::hash(seed, 0), pattern);
  for (std::uint32_t i = 0; i < count; ++i) {
    const transport::Uniform4 point = set[static_cast<int>(i)];
    points.push_back({point.xy(), point.z});
  }
  DrawnSamples drawn;
  drawn.samples.reserve(count);
  const auto start = std::chrono::steady_clock::now();
  for (const reflectance::Uniforms& xi : points) {
    if (const auto sample = reflector.sample(u, xi)) drawn.samples.push_back(*sample);
  }
  drawn.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  drawn.rejected = count - drawn.samples.size();
  return drawn;
}

WeightStatistics statistics_of(const DrawnSamples& drawn, double albedo) {
  WeightStatistics statistics;
  statistics.albedo = albedo;
  if (drawn.count() == 0 || !(albedo > 0)) return statistics;
  const auto count = static_cast<double>(drawn.count());
  double squares = 0;
  for (const reflectance::ScatterSample& sample : drawn.samples) {
    const double weight = reflectance::mean(sample.weight) / albedo;
    statistics.mean += weight / count;
    squares += weight * weight / count;
    statistics.largest = std::max(statistics.largest, weight);
    statistics.specular += sample.is_specular ? 1 / count : 0;
  }
  statistics.variance = std::max(0.0, squares - statistics.mean * statistics.mean);
  statistics.rejected = static_cast<double>(drawn.rejected) / count;
  return statistics;
}

}  // namespace studies
