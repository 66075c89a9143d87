// The energy-preserving Oren-Nayar model against its paper.
#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "tests/reflectance/brdf_cases.h"

namespace {

using reflectance::Brdf;
using reflectance::Rgb;
using test::brdf_of;
using test::easy_pairs;
using test::Pair;

// Portsmouth, Kutz and Hill 2025: single scattering with s and t, and 1 less the albedos.
TEST(Eon, IsAsPrinted) {
  const Brdf brdf = brdf_of("eon rough=0.6 kd=0.8");
  const double scale = 1 / (1 + (0.5 - 2 / (3 * M_PI)) * 0.6);
  const auto albedo = [scale](double cosine) {
    const double theta = std::acos(cosine);
    const double sine = std::sin(theta);
    const double slope = sine * (theta - sine * cosine);
    return scale * (1 + 0.6 / M_PI * (slope + 2 / 3.0 * (sine / cosine * (1 - std::pow(sine, 3)) - sine)));
  };
  const double mean = scale * (1 + (2 / 3.0 - 28 / (15 * M_PI)) * 0.6);
  const double further = 0.64 * mean / (1 - 0.8 * (1 - mean));
  for (const Pair& pair : easy_pairs()) {
    const Imath::V3d u(pair.u);
    const Imath::V3d v(pair.v);
    const double s = u.dot(v) - u.z * v.z;
    const double t = s > 0 ? std::max(u.z, v.z) : 1;
    const double expected =
        0.8 * scale * (1 + 0.6 * s / t) + further * (1 - albedo(u.z)) * (1 - albedo(v.z)) / (1 - mean);
    EXPECT_NEAR(evaluate(brdf, pair.u, pair.v).x, expected / M_PI, 1e-5);
  }
}

// Light that facets scatter to each other meets their colour several times.
TEST(Eon, SaturatesColoursTheRougherItIs) {
  const auto ratio = [](const std::string& rough) {
    const Brdf brdf = brdf_of("eon kd=(0.8, 0.4, 0.4) rough=" + rough);
    const Rgb value = evaluate(brdf, test::direction(80, 0), test::direction(80, 180));
    return value.x / value.y;
  };
  EXPECT_NEAR(ratio("0"), 2, 1e-5);
  EXPECT_GT(ratio("0.5"), 2.01F);
  EXPECT_GT(ratio("1"), ratio("0.5") + 0.01F);
}

}  // namespace
