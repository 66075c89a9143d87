#include "samples/studies/sampling/errors.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "renderer/transport/sobol.h"

namespace study {
namespace {

using reflectance::Uniforms;

/// Random numbers of one estimate after the other.
class Numbers {
 public:
  explicit Numbers(Points points) : points_(points) {}

  void begin_estimate() {
    seed_ = transport::hash(++estimate_, 1);
    index_ = 0;
  }

  Uniforms next() {
    if (points_ == Sobol) {
      const transport::Uniform4 point = transport::sobol_point(index_++, seed_);
      return {point.xy(), point.z};
    }
    const float x = uniform();
    const float y = uniform();
    return {{x, y}, uniform()};
  }

 private:
  float uniform() { return static_cast<float>(random_() >> 8U) * 0x1p-24F; }

  Points points_;
  std::uint32_t estimate_ = 0;
  std::uint32_t seed_ = 0;
  std::uint32_t index_ = 0;
  std::mt19937 random_ = std::mt19937(1);
};

std::array<double, LightCount> squared_errors(const Technique& technique, const Setting& setting, int samples,
                                              Numbers& numbers) {
  Setting::Estimate estimate(setting);
  numbers.begin_estimate();
  for (int i = 0; i < samples; ++i) {
    const auto drawn = technique.sample(setting.view(), numbers.next());
    if (drawn) estimate.add(*drawn, 1.0 / samples);
  }
  return estimate.squared_errors();
}

}  // namespace

double Error::value() const { return std::sqrt(square); }

double Error::noise() const { return square > 0 ? std::sqrt(variance) / (2 * square) : 0; }

Errors measure_errors(const Technique& technique, const Setting& setting, Points points, int repeats) {
  Numbers numbers(points);
  Errors errors;
  for (std::size_t count = 0; count < SampleCounts.size(); ++count) {
    const int samples = SampleCounts[count];
    const int tries = repeats * std::min(16, SampleCounts.back() / samples);
    std::array<double, LightCount> fourths = {};
    for (int i = 0; i < tries; ++i) {
      const auto squares = squared_errors(technique, setting, samples, numbers);
      for (std::size_t light = 0; light < LightCount; ++light) {
        errors[light][count].square += squares[light] / tries;
        fourths[light] += squares[light] * squares[light] / tries;
      }
    }
    for (std::size_t light = 0; light < LightCount; ++light) {
      Error& error = errors[light][count];
      error.variance = std::max(0.0, fourths[light] - error.square * error.square) / tries;
    }
  }
  return errors;
}

}  // namespace study
