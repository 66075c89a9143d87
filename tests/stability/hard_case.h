// A catalogue of numerically hard cases, each measured with our code and with naive code.
// renderer/STABILITY.md is generated from it.
#pragma once

#include <algorithm>
#include <cmath>
#include <ostream>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/reflectance/geometry.h"

namespace test {

/// The errors of a case, such as the worst relative error against our formula in double; infinite if a result
/// is infinite or NaN.
struct Errors {
  double ours = 0;
  double naive = 0;
  /// The error of the naive formula in double: the formula is right and fails only in float. 0 if the naive
  /// code is not a formula.
  double naive_in_double = 0;

  void include(const Errors& more) {
    ours = std::max(ours, more.ours);
    naive = std::max(naive, more.naive);
    naive_in_double = std::max(naive_in_double, more.naive_in_double);
  }
};

constexpr std::string_view RelativeError = "relative error";

enum class Kind {
  Plain,
  Noisy,  ///< the figure is sampling noise more than rounding
  Long,   ///< takes more than a few seconds
};

struct HardCase {
  std::string_view name;
  std::string_view naive_code;
  std::string_view our_code;
  /// The documented error, within a factor of 4 of the measured one. It exceeds the bound unless naive code
  /// is good enough.
  double naive_error;
  double bound;  ///< upper limit of our error
  double error;  ///< the documented error, within a factor of 2, or 4 for noise
  Errors (*measure)();
  std::string_view measured = RelativeError;  ///< the quantity of the errors
  Kind kind = Kind::Plain;

  bool naive_holds() const { return naive_error <= bound; }
};

/// A table of the document.
struct Section {
  std::string_view mark;  ///< its name in the document's marker
  std::vector<HardCase> cases;
};

inline void PrintTo(const HardCase& hard_case, std::ostream* out) {  // NOLINT(readability-identifier-naming)
  *out << hard_case.name;
}

// Cases in the order of the document: reflectance,
std::vector<HardCase> direction_cases();
std::vector<HardCase> fresnel_cases();
std::vector<HardCase> lobe_cases();
std::vector<HardCase> model_cases();
// lights,
std::vector<HardCase> light_cases();
std::vector<HardCase> environment_cases();
// geometry,
std::vector<HardCase> triangle_cases();
std::vector<HardCase> ray_cases();
// and sums and samples.
std::vector<HardCase> sampling_cases();
std::vector<HardCase> image_cases();

std::vector<Section> catalogue();

/// Returns the long cases, or all others.
std::vector<HardCase> cases_of_length(bool is_long);

/// Fails unless the case measures what its row documents.
void expect_holds(const HardCase& hard_case);

/// Returns the name of a case as a test name.
std::string test_name(const HardCase& hard_case);

// Helpers of measurements.

template <class Real>
struct RealOf {
  using Type = Real;
};
template <class Real>
struct RealOf<Imath::Vec3<Real>> {
  using Type = Real;
};
/// The scalar type of a formula's argument, a number or a direction.
template <class Argument>
using Real = typename RealOf<Argument>::Type;

inline double relative_error(double value, double exact) {
  if (!std::isfinite(value)) return INFINITY;
  return value == exact ? 0 : std::abs(value - exact) / std::abs(exact);
}

/// Two directions, or one if a formula takes one.
struct Directions {
  reflectance::Vec3f u, v;
};

/// Compares our formula with the naive one, both generic lambdas. Skips values below `least`.
template <class Ours, class Naive>
Errors compare(const std::vector<Directions>& inputs, Ours ours, Naive naive, double least = 0) {
  using Vec3d = Imath::V3d;
  Errors errors;
  for (const auto& [u, v] : inputs) {
    const double exact = ours(Vec3d(u), Vec3d(v));
    if (exact < least) continue;
    // The naive formula in double gets vectors of unit length in double.
    const Vec3d a = Vec3d(u).normalized();
    const Vec3d b = Vec3d(v).normalized();
    errors.include({relative_error(ours(u, v), exact), relative_error(naive(u, v), exact),
                    relative_error(naive(a, b), ours(a, b))});
  }
  return errors;
}

/// Compares two formulas over numbers.
template <class Ours, class Naive>
Errors compare(const std::vector<float>& inputs, Ours ours, Naive naive) {
  Errors errors;
  for (const float x : inputs) {
    const double in_double = x;
    const double exact = ours(in_double);
    errors.include({relative_error(ours(x), exact), relative_error(naive(x), exact),
                    relative_error(naive(in_double), exact)});
  }
  return errors;
}

class Random {
 public:
  float uniform(float low, float high) { return std::uniform_real_distribution<float>(low, high)(random_); }
  float log_uniform(float low, float high) {
    return std::min(high, std::exp(uniform(std::log(low), std::log(high))));
  }

  reflectance::Vec3f direction(float z) {
    return reflectance::from_angles(z, std::sqrt((1 - z) * (1 + z)), 2 * reflectance::Pi * uniform(0, 1));
  }
  /// Returns a direction at most about this far from another.
  reflectance::Vec3f near(const reflectance::Vec3f& v, float distance) {
    const reflectance::Vec3f step{uniform(-1, 1), uniform(-1, 1),
                                  uniform(-1, 1)};  // the order of the calls is fixed
    return (v + distance * step).normalized();
  }

 private:
  std::mt19937 random_{7};
};

inline std::vector<float> numbers(float low, float high, int count = 10000) {
  Random random;
  std::vector<float> values;
  for (int i = 0; i < count; ++i) values.push_back(random.log_uniform(low, high));
  return values;
}

/// Returns pairs with v about the mirror direction of u, for a lobe of this width.
inline std::vector<Directions> about_the_mirror(float width, int count = 10000) {
  Random random;
  std::vector<Directions> pairs;
  for (int i = 0; i < count; ++i) {
    const reflectance::Vec3f u = random.direction(random.uniform(0.2F, 1));
    pairs.push_back({u, random.near(reflectance::mirrored(u), width)});
  }
  return pairs;
}

/// Returns pairs of directions whose cosines are in a range.
inline std::vector<Directions> grazing(float low, float high, int count = 10000) {
  Random random;
  std::vector<Directions> pairs;
  for (int i = 0; i < count; ++i) {
    pairs.push_back(
        {random.direction(random.log_uniform(low, high)), random.direction(random.log_uniform(low, high))});
  }
  return pairs;
}

}  // namespace test
