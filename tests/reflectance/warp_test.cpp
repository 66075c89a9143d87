// Properties of the inversion of adaptive trees beyond those of every scheme (sampling_test.cpp).
#include <cmath>

#include <gtest/gtest.h>

#include "renderer/reflectance/halton.h"
#include "renderer/reflectance/reflector.h"
#include "renderer/reflectance/schemes/view_square.h"
#include "renderer/reflectance/schemes/warp_trees.h"
#include "tests/reflectance/brdf_cases.h"
#include "tests/reflectance/scheme_cases.h"
#include "tests/reflectance/warp_weights.h"

namespace {

using reflectance::BilinearPatch;
using reflectance::Brdf;
using reflectance::Vec2f;
using reflectance::Vec3f;
using reflectance::WarpTrees;
using reflectance::WarpTreesSettings;

TEST(Warp, WeightsAreNearTheAlbedo) { test::expect_even_weights(50, 2000); }

TEST(Warp, NinetyTreesTakeNoMoreMemoryThanTheThesisOwn) {
  WarpTreesSettings settings;
  settings.phi_count = 1;
  for (const test::ThesisCase& one : test::thesis_cases()) {
    const WarpTrees trees(test::brdf_of(one.brdf), settings);
    EXPECT_LE(static_cast<double>(trees.bytes()) / 1024, std::max(256.0, one.kilobytes)) << one.brdf;
  }
}

/// Returns the relative variance of f cos / pdf at the view, by independent samples.
double relative_variance(const Brdf& brdf, const WarpTrees& trees, const Vec3f& u) {
  constexpr int Samples = 20000;
  test::Pairs random(9);
  double sum = 0;
  double squares = 0;
  for (int i = 0; i < Samples; ++i) {
    const auto drawn = trees.sample(u, random.next_pair());
    if (!drawn) continue;
    const double weight =
        double(reflectance::mean(evaluate(brdf, u, drawn->direction))) * drawn->direction.z / drawn->pdf;
    sum += weight;
    squares += weight * weight;
  }
  return squares * Samples / (sum * sum) - 1;
}

// Nine azimuths divide a quarter turn into eight gaps. In the middle of a gap the blend of its trees fits
// worst.
TEST(Warp, HasMoreAzimuthsWhereTheBlendOfTwoFitsBadlyBetweenThem) {
  constexpr double Quarter = reflectance::Pi / 2;
  int few_fit = 0;
  int few_fail = 0;
  for (const std::string text : {"ward sx=0.15 sy=0.4 ks=0.6 kd=0.3", "ward sx=0.3 sy=0.4 ks=0.6 kd=0.3",
                                 "ward sx=0.05 sy=0.5 ks=0.9 kd=0", "ward sx=0.03 sy=0.2 ks=0.5 kd=0.1"}) {
    const Brdf brdf = test::brdf_of(text);
    const auto trees_at = [&](int azimuths) {
      WarpTreesSettings settings;
      settings.theta_count = 1;
      settings.phi_count = azimuths;
      return WarpTrees(brdf, settings);
    };
    const WarpTrees few = trees_at(9);
    double variance = 0;
    for (int gap = 0; gap < 8; ++gap) {
      const Vec3f u = reflectance::direction_at(0.5F, static_cast<float>(Quarter * (gap + 0.5) / 8));
      variance = std::max(variance, relative_variance(brdf, few, u));
    }
    const std::size_t bytes = trees_at(0).bytes();
    if (variance < 0.04) {
      ++few_fit;
      EXPECT_EQ(bytes, few.bytes()) << text;
    } else if (variance > 0.09) {
      ++few_fail;
      EXPECT_EQ(bytes, trees_at(16).bytes()) << text;
    }
  }
  EXPECT_GE(few_fit, 1);
  EXPECT_GE(few_fail, 1);
}

TEST(Warp, DensityHasNoSeamBetweenTrees) {
  for (const std::string text : {"phong n=100 ks=0.4 kd=0.6", "ward sx=0.15 sy=0.4 ks=0.6 kd=0.3"}) {
    const Brdf brdf = test::brdf_of(text);
    const WarpTrees trees(brdf, WarpTreesSettings());
    // The light rotates with the view and stays at one position of the trees: only their blend changes.
    const auto pdf_at = [&](double theta) {
      const Vec3f u = test::direction(theta, 0);
      const reflectance::ViewColumns columns(reflectance::square_radius(u), !is_anisotropic(brdf));
      return static_cast<double>(trees.pdf(u, columns.direction({0, {0.93F, 0.61F}})));
    };
    double largest = 0;
    for (int i = 0; i < 40000; ++i) {
      const double theta = 1 + i * 0.002;
      largest = std::max(largest, std::abs(std::log(pdf_at(theta + 0.002) / pdf_at(theta))));
    }
    EXPECT_LT(largest, 2e-3) << text;
  }
}

TEST(Warp, KeepsEvenPointsEven) {
  constexpr std::uint32_t Count = 1024;
  constexpr int Repeats = 64;
  const WarpTrees trees(test::brdf_of("phong n=100 ks=0.4 kd=0.6"), WarpTreesSettings());
  const Vec3f u = test::direction(40, 25);
  // A light over half of the sky; any smooth function of the direction would do.
  const auto light = [](const Vec3f& v) { return std::max(0.0F, v.x + 0.3F * v.y) + v.z * v.z; };
  const auto estimate = [&](auto pair_at) {
    double sum = 0;
    for (std::uint32_t i = 0; i < Count; ++i) {
      const auto drawn = trees.sample(u, pair_at(i));
      if (drawn) sum += light(drawn->direction);
    }
    return sum / Count;
  };
  const double exact =
      estimate([](std::uint32_t i) { return reflectance::halton_point(i + 100000).direction; });
  double random_error = 0;
  double even_error = 0;
  for (int repeat = 0; repeat < Repeats; ++repeat) {
    test::Pairs random(static_cast<std::uint32_t>(repeat));
    random_error += std::pow(estimate([&](std::uint32_t) { return random.next_pair(); }) - exact, 2);
    // The points are shifted over the torus (Cranley-Patterson rotation).
    const Vec2f shift = random.next_pair();
    even_error += std::pow(estimate([&](std::uint32_t i) {
                             const Vec2f point = reflectance::halton_point(i).direction + shift;
                             return Vec2f(point.x - std::floor(point.x), point.y - std::floor(point.y));
                           }) - exact,
                           2);
  }
  EXPECT_LT(even_error, random_error / 20);
}

TEST(Warp, TakesNarrowLobesAndBlackBrdfs) {
  const WarpTrees black(test::brdf_of("diffuse kd=0"), WarpTreesSettings());
  EXPECT_FALSE(black.sample(test::direction(30, 0), {0.5F, 0.5F}));
  EXPECT_EQ(black.pdf(test::direction(30, 0), test::direction(10, 0)), 0);
  // The lobe is a quarter of a degree wide, while the trees' views are a degree apart.
  const test::Weights narrow = test::weights_of(test::brdf_of("lewis n=100000"), 50, 2000, 4);
  EXPECT_TRUE(narrow.are_valid);
  EXPECT_LT(narrow.over_one_and_a_half, 1e-2);
  EXPECT_LT(narrow.largest, 20);
  // One tree fits only its own view.
  WarpTreesSettings one;
  one.theta_count = 1;
  const Brdf brdf = test::brdf_of("ward sx=0.2 ks=0.5 kd=0.5");
  const WarpTrees tree(brdf, one);
  const auto drawn = tree.sample(test::direction(70, 200), {0.3F, 0.8F});
  ASSERT_TRUE(drawn);
  EXPECT_NEAR(drawn->pdf, tree.pdf(test::direction(70, 200), drawn->direction), 1e-3 * drawn->pdf);
}

TEST(Warp, RefusesAMirrorByName) {
  EXPECT_NE(unsupported_reason(test::scheme_of("adaptive"), test::brdf_of("specular")).find("'specular'"),
            std::string::npos);
}

TEST(BilinearWarp, FollowsThePatch) {
  const BilinearPatch patch = {1, 4, 0.5F, 2};
  constexpr int Side = 200;
  double left = 0;
  double low = 0;
  for (int i = 0; i < Side; ++i) {
    for (int k = 0; k < Side; ++k) {
      const Vec2f point = reflectance::warped(
          patch, {(static_cast<float>(i) + 0.5F) / Side, (static_cast<float>(k) + 0.5F) / Side});
      left += point.x < 0.5F ? 1.0 : 0.0;
      low += point.y < 0.5F ? 1.0 : 0.0;
    }
  }
  EXPECT_NEAR(left / Side / Side, 0.35, 0.01);
  EXPECT_NEAR(low / Side / Side, 7.0 / 12, 0.01);
}

TEST(ViewSquare, IsTheHemisphereAndBack) {
  test::Pairs random(5);
  for (int i = 0; i < 10000; ++i) {
    const Vec2f point = 2.0F * random.next_pair() - Vec2f(1);
    const Vec3f v = reflectance::from_square(point.x, point.y);
    EXPECT_NEAR(v.length(), 1, 1e-6);
    EXPECT_NEAR((reflectance::to_square(v) - point).length(), 0, 1e-5);
  }
}

TEST(ViewSquare, KeepsAreas) {
  test::Pairs random(6);
  double height = 0;
  constexpr int Count = 100000;
  for (int i = 0; i < Count; ++i) {
    const Vec2f point = 2.0F * random.next_pair() - Vec2f(1);
    height += double(reflectance::from_square(point.x, point.y).z) / Count;
  }
  EXPECT_NEAR(height, 0.5, 0.004);  // cos(theta) is uniform in solid angle
}

TEST(AutoScheme, IsAdaptiveWhereTheBrdfsOwnSamplerIsPoor) {
  const auto is_adaptive = [](const std::string& brdf) {
    reflectance::AutoScheme scheme;
    scheme.build(test::brdf_of(brdf));
    EXPECT_EQ(scheme.bytes() > 0, scheme.is_adaptive());
    return scheme.is_adaptive();
  };
  EXPECT_FALSE(is_adaptive("diffuse"));
  EXPECT_FALSE(is_adaptive("phong n=100 ks=0.4 kd=0.6"));
  EXPECT_FALSE(is_adaptive("specular"));
  EXPECT_TRUE(is_adaptive("ashikhmin ex=0 Rs=1 Rd=0"));
  EXPECT_TRUE(is_adaptive("torrance rough=1.5 nreal=2.485 nimag=3.433 ks=1 kd=0"));
}

}  // namespace
