// The visible noise that a render estimates from its own samples is compared with the visible difference from
// an image of far more samples.
#include "renderer/transport/visible_noise.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/transport/scene_helpers.h"

namespace {

using image::Image;
using image::Viewing;
using image::VisibleDifference;
using transport::Render;

constexpr int Seeds = 4;

const std::string Corner =
    "light begin rgb (6,6,6) (-2,-0.5,2) (0,1,0) (1,0,0) end light begin rgb (2,3,5) (0.2,-0.5,2.5) (0,1,0) "
    "(1,0,0) "
    "end " +
    test::quad("brdf diffuse kd=0.7", "(-9,-9,0) (9,-9,0) (9,9,0) (-9,9,0)") +
    test::quad("brdf phong n=20 ks=0.5 kd=0.4", "(-9,1,0) (9,1,0) (9,1,9) (-9,1,9)");

test::RenderSetup setup_of(int samples, std::uint32_t seed) {
  test::RenderSetup setup;
  setup.eye = grf::Vec3f(0, -3, 3);
  setup.target = grf::Vec3f(0, 0, 0.5F);
  setup.width = 64;
  setup.height = 48;
  setup.depth = 3;
  setup.samples = samples;
  setup.seed = seed;
  return setup;
}

transport::RenderSettings random_settings(const test::RenderSetup& setup) {
  transport::RenderSettings settings = settings_of(setup);
  // The error of independent samples is known to fall as 1 / sqrt(samples).
  settings.pattern = transport::SamplePattern::Independent;
  return settings;
}

/// The means over renders of what is estimated, and of what is true.
struct Means {
  VisibleDifference estimate;
  VisibleDifference truth;
  double samples_needed = 0;
};

Means means_of(const transport::CompiledScene& scene, const Image& reference, int samples,
               const Viewing& viewing) {
  const image::SeenImage seen_reference = seen(reference, viewing);
  Means means;
  for (std::uint32_t seed = 1; seed <= Seeds; ++seed) {
    Render render(scene, random_settings(setup_of(samples, seed)));
    render.run();
    const auto noise = visible_noise(render, viewing);
    if (!noise) throw std::runtime_error("no noise is known");
    const VisibleDifference truth =
        image::summary_of(visible_differences(seen(render.film().mean(), viewing), seen_reference));
    means.estimate.mean += noise->difference.mean / Seeds;
    means.estimate.percentile_95 += noise->difference.percentile_95 / Seeds;
    means.truth.mean += truth.mean / Seeds;
    means.truth.percentile_95 += truth.percentile_95 / Seeds;
    means.samples_needed += noise->samples_needed / Seeds;
  }
  return means;
}

class VisibleNoiseTest : public testing::Test {
 protected:
  // Rendered once for all tests.
  static const Image& reference(const transport::CompiledScene& scene) {
    static const Image image = render(scene, setup_of(4096, 77)).mean();
    return image;
  }

  const transport::CompiledScene scene_ = test::scene_of(Corner);
  const Image& reference_ = reference(scene_);
};

TEST_F(VisibleNoiseTest, IsTheDifferenceFromTheConvergedImage) {
  for (const double exposure : {0.0, 1.5}) {
    for (const int samples : {8, 64}) {
      const Means means = means_of(scene_, reference_, samples, {exposure, 40});
      EXPECT_GT(means.truth.percentile_95, 0.3);
      EXPECT_NEAR(means.estimate.mean / means.truth.mean, 1, 0.1) << samples << " samples, " << exposure;
      EXPECT_NEAR(means.estimate.percentile_95 / means.truth.percentile_95, 1, 0.1)
          << samples << " samples, " << exposure;
    }
  }
}

TEST_F(VisibleNoiseTest, IsNotSeenWithTheSamplesThatItNeeds) {
  for (const int samples : {8, 64}) {
    const Means means = means_of(scene_, reference_, samples, {});
    const Means then = means_of(scene_, reference_, static_cast<int>(means.samples_needed), {});
    EXPECT_NEAR(then.truth.percentile_95, 1, 0.12) << "from " << samples << ": " << means.samples_needed;
  }
}

TEST_F(VisibleNoiseTest, IsStopped) {
  Render render(scene_, settings_of(setup_of(2, 1)));
  render.run();
  EXPECT_TRUE(visible_noise(render, {}));
  EXPECT_FALSE(visible_noise(render, {}, [] { return true; }));
}

TEST_F(VisibleNoiseTest, IsUnknownWithoutTwoHalves) {
  Render render(scene_, settings_of(setup_of(1, 1)));
  render.run();
  EXPECT_FALSE(visible_noise(render, {}));
}

}  // namespace
