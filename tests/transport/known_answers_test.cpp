// What a surface sends to the eye under light of radiance 1 from all around is its albedo, whatever draws the
// directions: every BRDF that a scene can write, and every sampling scheme.
#include <cmath>

#include <gtest/gtest.h>

#include "renderer/reflectance/albedo.h"
#include "tests/reflectance/brdf_cases.h"
#include "tests/transport/scene_helpers.h"

namespace {

using test::Look;
using transport::CompiledScene;
using transport::Vec3f;

const std::vector<std::string> Schemes = {"auto",
                                          "own",
                                          "diffuse",
                                          "hemisphere",
                                          "sphere",
                                          "anisotropic",
                                          "reject",
                                          "adaptive nQT=12",
                                          "adaptive mode=reject nQT=6 nAnisoQT=6 res=200",
                                          "factored",
                                          "cascadeCDF"};

/// Those of the cases that one instance in a scene is.
std::vector<std::string> scene_cases() {
  std::vector<std::string> cases;
  for (const auto* list : {&test::plain_cases(), &test::stepped_cases()}) {
    for (const std::string& text : *list) {
      if (text.find('+') == std::string::npos && !text.starts_with("table")) cases.push_back(text);
    }
  }
  return cases;
}

class Albedo : public testing::TestWithParam<std::size_t> {};

/// A floor seen through a pinhole from one direction: its front is up z, and x is x.
Look look_from(const Vec3f& u) {
  Look look;
  look.eye = 4.0F * u;
  look.width = look.height = 4;
  look.samples = 1024;
  look.depth = 1;
  look.background = 1;
  look.field_of_view = 0.001F;
  return look;
}

TEST_P(Albedo, IsWhatAFloorShowsUnderAWhiteSky) {
  const std::string brdf = scene_cases()[GetParam()];
  std::vector<std::string> schemes = {Schemes.front()};
  // Tables take seconds to make, so each scheme has two BRDFs here; `sampling_test` has all, without a scene.
  if (GetParam() % 3 == 0) schemes.push_back(Schemes[GetParam() / 3 % Schemes.size()]);
  for (const std::string& scheme : schemes) {
    const CompiledScene scene =
        test::scene_of(test::quad("brdf " + brdf + " pdf " + scheme, "(-9,-9,0) (9,-9,0) (9,9,0) (-9,9,0)"));
    for (const float theta : {0.3F, 1.1F}) {
      const Vec3f u = reflectance::from_angles(std::cos(theta), std::sin(theta), 0.7F);
      const auto point = scene.intersect({4.0F * u, -u});
      ASSERT_TRUE(point);
      const auto& reflector = *scene.reflector(*point->surface);
      const double expected = reflectance::mean(reflectance::albedo(reflector, u));
      const test::Estimate shown = test::mean_radiance(test::render(scene, look_from(u)));
      // 166 comparisons of which each channel's noise is known from two halves of few pixels.
      EXPECT_NEAR(shown.mean, expected, 6 * shown.deviation + 3e-3 * expected) << brdf << " by " << scheme;
      EXPECT_LT(shown.deviation, 0.05 * expected + 1e-4) << brdf << " by " << scheme;
      if (test::info_of(reflector.brdf()).not_conserving.empty()) {
        EXPECT_LT(shown.mean, 1 + 6 * shown.deviation + 2e-3) << brdf << " by " << scheme;
      }
    }
  }
}

/// The mean albedo over a sphere's disc, as it is seen from far away: the radius is the sine of the angle.
double albedo_over_disc(const reflectance::Reflector& reflector) {
  constexpr int Rings = 64;
  double sum = 0;
  for (int i = 0; i < Rings; ++i) {
    const float sine = std::sqrt((static_cast<float>(i) + 0.5F) / Rings);
    const Vec3f u(sine, 0, std::sqrt(1 - sine * sine));
    sum += reflectance::mean(reflectance::albedo(reflector, u, 512)) / Rings;
  }
  return sum;
}

TEST_P(Albedo, IsWhatASphereShowsUnderAWhiteSky) {
  const std::string brdf = scene_cases()[GetParam()];
  const CompiledScene scene = test::scene_of(test::sphere("brdf " + brdf, 120, true));
  const auto point = scene.intersect({Vec3f(0, 0, 4), Vec3f(0, 0, -1)});
  ASSERT_TRUE(point);
  const auto& reflector = *scene.reflector(*point->surface);
  if (reflectance::is_anisotropic(reflector.brdf())) return;  // what is seen depends on how its frame lies
  Look look;
  look.eye = Vec3f(0, 0, 1000);
  look.field_of_view = static_cast<float>(2 * std::atan(1.0 / 1000) * 180 / M_PI);
  look.width = look.height = 48;
  look.samples = 36;
  look.depth = 1;
  look.background = 1;
  const test::Estimate shown = test::mean_radiance(test::render(scene, look));
  const double disc = M_PI / 4;  // of the image
  const double expected = disc * albedo_over_disc(reflector) + 1 - disc;
  // 120 rows of facets hide what interpolated normals send under them.
  EXPECT_NEAR(shown.mean, expected, 5 * shown.deviation + 0.01 * disc) << brdf;
}

INSTANTIATE_TEST_SUITE_P(Brdfs, Albedo, testing::Range(std::size_t(0), scene_cases().size()));

}  // namespace
