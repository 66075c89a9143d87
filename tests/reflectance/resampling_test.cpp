#include "renderer/reflectance/resampling.h"

#include <cmath>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include "tests/reflectance/brdf_cases.h"
#include "tests/reflectance/scheme_cases.h"
#include "tests/statistics/quadrature.h"

namespace {

using reflectance::Reflector;
using reflectance::Resampler;
using reflectance::Resampling;
using reflectance::Rgb;
using reflectance::Uniforms;
using reflectance::Vec3f;

class RandomNumbers {
 public:
  Uniforms next() {
    const float x = uniform();
    const float y = uniform();
    return {{x, y}, uniform()};
  }
  float uniform() { return static_cast<float>(random_() >> 8U) * 0x1p-24F; }

 private:
  std::mt19937 random_{21};
};

/// A smooth, coloured light that is narrow compared with a diffuse BRDF.
Rgb light(const Vec3f& v) {
  const Vec3f centre = Vec3f(-0.6F, 0.3F, 0.7F).normalized();
  return Rgb(1, 0.5F, 0.25F) * (20 * std::exp(30 * (v.dot(centre) - 1))) + Rgb(0.1F);
}
/// Visibility behind a wall.
float visibility(const Vec3f& v) { return v.x < -0.4F ? 1.0F : 0.0F; }

struct Estimate {
  double mean = 0;
  double variance = 0;  ///< of one estimate

  double deviation(int runs) const { return std::sqrt(variance / runs); }
};

constexpr int Runs = 20000;

Estimate resampled(const Reflector& reflector, const Vec3f& u, const Resampling& counts) {
  RandomNumbers random;
  Resampler resampler;
  double sum = 0;
  double squares = 0;
  for (int i = 0; i < Runs; ++i) {
    double estimate = 0;
    const auto draw = [&](int) { return reflector.sample(u, random.next()); };
    const auto use = [&](const Vec3f& v, const Rgb& share) {
      estimate += double(visibility(v)) * double(reflectance::mean(share));
    };
    reflectance::resample(resampler, counts, random.uniform(), draw, light, use);
    sum += estimate;
    squares += estimate * estimate;
  }
  return {sum / Runs, squares / Runs - sum / Runs * sum / Runs};
}

double by_quadrature(const Reflector& reflector, const Vec3f& u) {
  const statistics::Quadrature quadrature(
      [&](const Vec3f& v) {
        return double(reflectance::mean(reflector.evaluate(u, v) * light(v))) * double(visibility(v) * v.z);
      },
      reflectance::mirrored(u), 1e-7, 4);
  return quadrature.over_hemisphere();
}

TEST(Resampling, IsUnbiased) {
  const Vec3f u = test::direction(40, 10);
  for (const char* brdf :
       {"diffuse kd=0.7", "phong n=20 ks=0.5 kd=0.3", "ward sx=0.3 sy=0.1 ks=0.6 kd=0.2"}) {
    for (const char* scheme : {"auto", "diffuse"}) {
      const Reflector reflector(test::brdf_of(brdf), test::scheme_of(scheme));
      const double exact = by_quadrature(reflector, u);
      for (const Resampling& counts :
           {Resampling{1, 1}, Resampling{2, 1}, Resampling{16, 1}, Resampling{16, 4}, Resampling{7, 7}}) {
        const Estimate estimate = resampled(reflector, u, counts);
        EXPECT_NEAR(estimate.mean, exact, 4.5 * estimate.deviation(Runs) + 1e-4 * exact)
            << brdf << " " << scheme << " " << counts.candidates << " " << counts.chosen;
      }
    }
  }
}

// The purpose of resampling: less variance for equally many (N) visibility rays.
TEST(Resampling, HasLessVarianceThanAsManySamples) {
  const Vec3f u = test::direction(40, 10);
  const Reflector diffuse(test::brdf_of("diffuse kd=0.7"), test::scheme_of("diffuse"));
  const double plain = resampled(diffuse, u, {1, 1}).variance;
  EXPECT_LT(resampled(diffuse, u, {16, 1}).variance, plain / 5);
  EXPECT_LT(resampled(diffuse, u, {64, 4}).variance, resampled(diffuse, u, {4, 4}).variance / 5);
}

// Includes a delta part among the candidates.
TEST(Resampling, CountsMirrorsToo) {
  const Vec3f u = test::direction(40, 10);
  const Reflector coupled(test::brdf_of("coupled Rm=1 Ro=0.3"), test::scheme_of("auto"));
  const Vec3f mirror = reflectance::mirrored(u);
  const double exact =
      by_quadrature(coupled, u) +
      double(reflectance::mean(reflectance::specular_weight(coupled.brdf(), u) * light(mirror))) *
          double(visibility(mirror));
  const Estimate estimate = resampled(coupled, u, {8, 2});
  EXPECT_NEAR(estimate.mean, exact, 4.5 * estimate.deviation(Runs));
}

TEST(Resampler, RepeatsNoCandidateMoreThanNeeded) {
  RandomNumbers random;
  for (int run = 0; run < 1000; ++run) {
    Resampler resampler;
    std::vector<float> weights;
    float total = 0;
    const int candidates = 1 + run % 20;
    for (int j = 0; j < candidates; ++j) {
      weights.push_back(j % 3 == 1 ? 0 : random.uniform());
      total += weights.back();
      resampler.add(Vec3f(static_cast<float>(j), 0, 0), Rgb(weights.back()));
    }
    const int count = 1 + run % 7;
    double sum = 0;
    resampler.choose(count, random.uniform(), [&](const Vec3f& v, const Rgb& estimate) {
      const auto weight = double(weights[static_cast<std::size_t>(v.x)]);
      ASSERT_GT(weight, 0);
      const double share = weight / double(total);
      const double copies = double(estimate.x) / double(total) * candidates * count;
      EXPECT_NEAR(copies, std::round(copies), 1e-4);
      EXPECT_LE(std::abs(copies - share * count), 1.0001);
      sum += copies;
    });
    EXPECT_NEAR(sum, count, 1e-3);
  }
}

TEST(Resampler, ChoosesNothingOfNothing) {
  Resampler resampler;
  const auto fail = [](const Vec3f&, const Rgb&) { FAIL(); };
  resampler.choose(3, 0.5F, fail);
  resampler.add(Vec3f(0, 0, 1), Rgb(0));
  resampler.choose(3, 0.5F, fail);
}

}  // namespace
