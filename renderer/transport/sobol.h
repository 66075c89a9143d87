// Owen-scrambled Sobol points for path dimensions.
#pragma once

#include <array>
#include <cstdint>

#include "grf/math.h"

namespace transport {

/// Well-mixed 32 bits from two.
std::uint32_t hash(std::uint32_t a, std::uint32_t b);

/// Four numbers in [0,1). The first two are the best spread, and any two are a good pair.
struct Uniform4 {
  float x = 0, y = 0, z = 0, w = 0;

  grf::Vec2f xy() const { return {x, y}; }
};

/// Point `index` of an Owen-scrambled and shuffled four-dimensional Sobol sequence. Sequences of different
/// seeds are independent, so each group of dimensions of a path takes a seed of its own
/// (Burley 2020, "Practical hash-based Owen scrambling", section 5).
Uniform4 sobol_point(std::uint32_t index, std::uint32_t seed);

/// How the random numbers of different samples have to do with each other.
enum class Points {
  Sobol,        ///< they are points of one sequence, well spread together
  Independent,  ///< not at all
};

/// Some points for one purpose, that are well spread together, or independent.
class PointSet {
 public:
  PointSet(std::uint32_t first, std::uint32_t seed, Points points)
      : first_(first), seed_(seed), points_(points) {}

  Uniform4 operator[](int index) const {
    const std::uint32_t number = first_ + static_cast<std::uint32_t>(index);
    return points_ == Points::Sobol ? sobol_point(number, seed_) : sobol_point(0, hash(seed_, number));
  }

 private:
  std::uint32_t first_;
  std::uint32_t seed_;
  Points points_;
};

struct TwoPoints {
  Uniform4 first, second;
};

/// The random numbers of one path, a function of what was counted alone: image seed, pixel, scrambling,
/// sample, and how many points of it were taken.
class PathNumbers {
 public:
  PathNumbers(std::uint32_t sequence_seed, std::uint32_t sample, Points points = Points::Sobol);

  Uniform4 next();

  /// The same as two calls of `next`, in less time.
  TwoPoints next_two();

  /// As many points for one purpose. Those of all samples together are the points of one sequence, if each
  /// sample asks for as many; or independent, as the points of paths are.
  PointSet next_set(int count) {
    return {sample_ * static_cast<std::uint32_t>(count), hash(seed_, group_++), points_};
  }

 private:
  std::uint32_t seed_;
  std::uint32_t sample_;
  std::uint32_t reversed_sample_;
  std::uint32_t group_ = 0;
  Points points_;
};

}  // namespace transport
