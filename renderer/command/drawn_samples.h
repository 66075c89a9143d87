#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "renderer/reflectance/reflector.h"

namespace command {

/// What a reflector drew for one view.
struct DrawnSamples {
  std::vector<reflectance::ScatterSample> samples;  ///< those that carry something
  std::size_t rejected = 0;                         ///< the others
  double seconds = 0;                               ///< of drawing alone

  std::size_t count() const { return samples.size() + rejected; }
};

/// Draws by points that fill space evenly, as paths do (scrambled Sobol points). The seed chooses the points.
DrawnSamples draw_samples(const reflectance::Reflector& reflector, const reflectance::Vec3f& u,
                          std::uint32_t count, std::uint32_t seed);

/// What the weights f cos / density of samples tell of an estimate by them. All are means over RGB, and in
/// albedos: those of a perfect scheme are 1.
struct WeightStatistics {
  double albedo = 0;    ///< of the BRDF, mirror part included
  double mean = 0;      ///< 1 but for noise, or the scheme is biased
  double variance = 0;  ///< samples that carry nothing count as 0
  double largest = 0;
  double mirrored = 0;  ///< share of the samples that are the mirror part's
  double rejected = 0;  ///< share of the samples that carry nothing
};

WeightStatistics statistics_of(const DrawnSamples& drawn, double albedo);

}  // namespace command
