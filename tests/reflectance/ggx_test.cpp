// GGX's energy against quadrature, a closed form, and a random walk over the same surface.
#include "renderer/reflectance/ggx.h"

#include <cmath>
#include <numbers>
#include <optional>
#include <random>

#include <gtest/gtest.h>

#include "tests/reflectance/albedo.h"
#include "tests/reflectance/random_walk.h"

namespace {

using Imath::V3d;
using reflectance::Brdf;
using reflectance::Ggx;
using reflectance::Rgb;
using reflectance::Vec3f;

using GgxInDouble = reflectance::glsl::GgxFormula<double>;

constexpr double Pi = std::numbers::pi;

Ggx white(float alpha, int scattering) {
  Ggx ggx;
  ggx.alpha = ggx.ay = alpha;
  ggx.f0 = Rgb(1);
  ggx.scattering = scattering;
  ggx.prepare();
  return ggx;
}

double sampled_albedo(const Ggx& ggx, double degrees, int samples) {
  const Vec3f u = test::direction(degrees, 25);
  std::mt19937 random(7);
  std::uniform_real_distribution<float> uniform(0, 1);
  double sum = 0;
  for (int i = 0; i < samples; ++i) {
    const auto sample = ggx.sample(u, {{uniform(random), uniform(random)}, uniform(random)});
    if (sample) sum += sample->weight.x;
  }
  return sum / samples;
}

TEST(Ggx, OfWhiteMetalReflectsAllLightAtEveryRoughnessAndAngle) {
  for (const float alpha : {0.01F, 0.03F, 0.1F, 0.25F, 0.5F, 0.75F, 1.0F}) {
    for (const double angle : {0.0, 30.0, 60.0, 75.0, 85.0, 89.0}) {
      EXPECT_NEAR(sampled_albedo(white(alpha, 0), angle, 200'000), 1, 0.01) << alpha << " at " << angle;
      EXPECT_NEAR(sampled_albedo(white(alpha, 1), angle, 200'000), 1, 0.01) << alpha << " at " << angle;
    }
  }
}

// With alpha = 1 all normals of the hemisphere are as frequent; the integral is elementary for light from the
// normal.
TEST(Ggx, LosesLog2OfLightFromTheNormalIfAllNormalsAreAsFrequent) {
  EXPECT_NEAR(test::albedo(Brdf(white(1, 2)), Vec3f(0, 0, 1), 1e-7), 1 - std::numbers::ln2, 1e-5);
  EXPECT_NEAR(GgxInDouble().ggx_missing(1, 1), std::numbers::ln2, 0.005);
}

TEST(Ggx, KnowsTheMeanOfWhatFacetsDoNotReflect) {
  constexpr int Count = 200'000;
  for (const double alpha : {0.01, 0.1, 0.3, 0.6, 1.0}) {
    double sum = 0;
    for (int i = 0; i < Count; ++i) {
      const double c = (i + 0.5) / Count;
      sum += 2 * c * GgxInDouble().ggx_missing(c, alpha) / Count;
    }
    EXPECT_NEAR(GgxInDouble().ggx_mean_missing(alpha), sum, 0.006 * sum) << alpha;
  }
}

TEST(Ggx, LosesWhatARandomWalkReflectsMoreThanOnce) {
  constexpr int Walks = 100'000;
  for (const double alpha : {0.05, 0.2, 0.5, 1.0}) {
    test::RandomWalk walk(alpha, 3);
    for (const double angle : {1.0, 45.0, 75.0, 86.0}) {
      const V3d u(test::direction(angle, 0));
      int several = 0;
      for (int i = 0; i < Walks; ++i) several += walk.run(u, [](double) { return 1.0; }).second > 1 ? 1 : 0;
      EXPECT_NEAR(GgxInDouble().ggx_missing(u.z, alpha), static_cast<double>(several) / Walks, 0.007)
          << alpha << " at " << angle;
    }
  }
}

// A metal, whose facets absorb a part at each bounce. Kulla and Conty's series takes each bounce after the
// first for one like all others, and at alpha = 0.8 loses 4 % by it.
TEST(Ggx, ReflectsAsMuchAsARandomWalkOverAMetal) {
  constexpr int Walks = 100'000;
  constexpr double Real = 0.617;
  constexpr double Imaginary = 2.63;
  for (const double alpha : {0.1, 0.4, 0.8}) {
    test::RandomWalk walk(alpha, 5);
    Ggx copper = white(static_cast<float>(alpha), 0);
    copper.f0 = Rgb(0);
    copper.nreal = Rgb(static_cast<float>(Real));
    copper.nimag = Rgb(static_cast<float>(Imaginary));
    copper.prepare();
    for (const double angle : {1.0, 45.0, 75.0}) {
      const V3d u(test::direction(angle, 25));
      double sum = 0;
      for (int i = 0; i < Walks; ++i) {
        sum += walk.run(u, [](double c) { return GgxInDouble().fresnel(c, Real, Imaginary); }).first;
      }
      EXPECT_NEAR(sampled_albedo(copper, angle, Walks), sum / Walks, 0.05 * sum / Walks)
          << alpha << " at " << angle;
    }
  }
}

TEST(Ggx, TintsItsReflectanceAt82Degrees) {
  const V3d f0(0.9, 0.6, 0.3);
  const V3d f82(0.5, 0.8, 1);
  const auto at = [&](double c) {
    const double sine = std::sqrt(1 - c * c);
    return GgxInDouble().ggx_reflectance(V3d(sine, 0, c), V3d(-sine, 0, c), V3d(1), V3d(0), f0, f82);
  };
  const double power = std::pow(6 / 7.0, 5);
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(at(1)[k], f0[k], 1e-12);
    EXPECT_NEAR(at(1 / 7.0)[k], f82[k] * (f0[k] + (1 - f0[k]) * power), 1e-7);
    EXPECT_NEAR(at(1e-9)[k], 1, 1e-6);
  }
}

// The mean over all angles, by the midpoint rule.
TEST(Ggx, KnowsTheMeanReflectanceOfMetals) {
  constexpr int Count = 20'000;
  for (const auto& [n, k] : {std::pair(0.2, 3.6), std::pair(0.617, 2.63), std::pair(2.5, 3.4)}) {
    double sum = 0;
    for (int i = 0; i < Count; ++i) {
      const double c = (i + 0.5) / Count;
      sum += 2 * c * GgxInDouble().fresnel(c, n, k) / Count;
    }
    EXPECT_NEAR(GgxInDouble().ggx_mean_reflectance(V3d(n), V3d(k), V3d(0), V3d(1)).x, sum, 0.01) << n;
  }
}

TEST(Ggx, IsTurnedByItsRotation) {
  Ggx along = white(0.1F, 0);
  along.ay = 0.4F;
  along.prepare();
  Ggx turned = along;
  turned.rotation = 0.7F;
  const double degrees = 0.7 * 180 / Pi;
  for (const auto& [from, to] : {std::pair(10.0, 190.0), std::pair(70.0, 240.0), std::pair(120.0, 20.0)}) {
    const Rgb expected = along.evaluate(test::direction(40, from), test::direction(55, to));
    const Rgb value = turned.evaluate(test::direction(40, from + degrees), test::direction(55, to + degrees));
    EXPECT_NEAR(value.x, expected.x, 1e-4F * expected.x);
  }
}

}  // namespace
