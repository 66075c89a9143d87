// Owen-scrambled Sobol' sequences give the dimensions of paths.
#pragma once

#include <array>
#include <cstdint>

#include "grf/math.h"

namespace transport {

/// Hashes two 32-bit values to one.
std::uint32_t hash(std::uint32_t a, std::uint32_t b);

/// A 4D sample in [0,1). The first two dimensions are the best distributed, and any two are well distributed.
struct Uniform4 {
  float x = 0, y = 0, z = 0, w = 0;

  grf::Vec2f xy() const { return {x, y}; }
};

/// Returns sample `index` of an Owen-scrambled and shuffled 4D Sobol' sequence. Sequences with different
/// seeds are independent, so each four dimensions of a path use a seed of their own (Burley 2020, "Practical
/// hash-based Owen scrambling", section 5).
Uniform4 sobol_point(std::uint32_t index, std::uint32_t seed);

/// The pattern of the random numbers of different samples.
enum class SamplePattern {
  Sobol,        ///< low-discrepancy: samples of one Owen-scrambled sequence
  Independent,  ///< independent random numbers
};

/// A set of samples for one purpose: low-discrepancy, or independent.
class SampleSet {
 public:
  SampleSet(std::uint32_t first, std::uint32_t seed, SamplePattern pattern)
      : first_(first), seed_(seed), pattern_(pattern) {}

  Uniform4 operator[](int index) const {
    const std::uint32_t number = first_ + static_cast<std::uint32_t>(index);
    return pattern_ == SamplePattern::Sobol ? sobol_point(number, seed_)
                                            : sobol_point(0, hash(seed_, number));
  }

 private:
  std::uint32_t first_;
  std::uint32_t seed_;
  SamplePattern pattern_;
};

struct SamplePair {
  Uniform4 first, second;
};

/// The sampler of one path. Its values depend only on the image's seed, the pixel, the scrambling, the sample
/// index and the number of earlier calls.
class PathSampler {
 public:
  PathSampler(std::uint32_t sequence_seed, std::uint32_t sample,
              SamplePattern pattern = SamplePattern::Sobol);

  Uniform4 next();

  /// Returns the same as two calls of `next`, in less time.
  SamplePair next_two();

  /// Returns the sampler of path `index` of `count` into which this one splits. Over all samples, the split
  /// paths share one sequence per dimension.
  PathSampler branch(int index, int count) const {
    constexpr std::uint32_t Apart = 0x80000000U;  // apart from the seeds of dimensions
    return {hash(seed_, Apart + dimension_),
            sample_ * static_cast<std::uint32_t>(count) + static_cast<std::uint32_t>(index), pattern_};
  }

  /// Returns a random word for decisions that need no stratification, without taking a dimension: it differs
  /// between samples, and after each call of `next`, `next_two` or `next_set`.
  std::uint32_t word() const {
    constexpr std::uint32_t Apart = 0xC0000000U;  // apart from the seeds of dimensions and of split paths
    return hash(hash(seed_, Apart + dimension_), sample_);
  }

  /// Returns `count` samples for one purpose. Over all samples of the pixel they form one sequence, if each
  /// asks for the same number; independent if the pattern is.
  SampleSet next_set(int count) {
    return {sample_ * static_cast<std::uint32_t>(count), hash(seed_, dimension_++), pattern_};
  }

 private:
  std::uint32_t seed_;
  std::uint32_t sample_;
  std::uint32_t reversed_sample_;
  std::uint32_t dimension_ = 0;
  SamplePattern pattern_;
};

}  // namespace transport
