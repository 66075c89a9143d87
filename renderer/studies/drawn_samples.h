#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "renderer/reflectance/reflector.h"
#include "renderer/transport/sobol.h"

namespace studies {

/// Samples of a reflector for one view direction.
struct DrawnSamples {
  std::vector<reflectance::ScatterSample> samples;  ///< with non-zero weight
  std::size_t rejected = 0;                         ///< number of samples with zero weight
  double seconds = 0;                               ///< time spent sampling only

  std::size_t count() const { return samples.size() + rejected; }
};

/// Draws samples by scrambled Sobol points, as the path tracer does, or by independent random numbers. The
/// seed chooses the scrambling.
DrawnSamples draw_samples(const reflectance::Reflector& reflector, const reflectance::Vec3f& u,
                          std::uint32_t count, std::uint32_t seed,
                          transport::SamplePattern pattern = transport::SamplePattern::Sobol);

/// Statistics of the sample weights f cos / pdf. All are means over RGB, in units of the albedo: the weights
/// of perfect importance sampling are 1.
struct WeightStatistics {
  double albedo = 0;    ///< of the BRDF, specular part included
  double mean = 0;      ///< 1 up to noise, unless the scheme is biased
  double variance = 0;  ///< rejected samples count as 0
  double largest = 0;
  double specular = 0;  ///< fraction of samples from the specular (delta) part
  double rejected = 0;  ///< fraction of samples with zero weight
};

WeightStatistics statistics_of(const DrawnSamples& drawn, double albedo);

}  // namespace studies
