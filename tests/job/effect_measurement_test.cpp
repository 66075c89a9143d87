#include "renderer/job/effect_measurement.h"

#include <array>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "renderer/job/render_job.h"
#include "tests/support/temporary_folder.h"

namespace {

using job::MeasuredEffect;
using transport::Effect;

/// A box of 2 x 2 x 2 seen from its centre, all of whose faces emit 1 and reflect half of the light.
const std::string Furnace =
    "begin mesh brdf diffuse kd=0.5 light rgb (1,1,1) begin vertexs (-1,-1,-1) (1,-1,-1) (1,1,-1) (-1,1,-1) "
    "(-1,-1,1) (1,-1,1) (1,1,1) (-1,1,1) end vertexs begin faces (0,1,2,3) (4,7,6,5) (0,4,5,1) (2,6,7,3) "
    "(0,3,7,4) (1,5,6,2) end faces end mesh";

/// A white plane that fills the image, with vertices of half that colour, under a background of 1.
const std::string GreyedPlane =
    "begin mesh brdf diffuse kd=0.8 begin vertexs rgb (0.5,0.5,0.5) (-9,-9,0) rgb (0.5,0.5,0.5) (9,-9,0) "
    "rgb (0.5,0.5,0.5) (9,9,0) rgb (0.5,0.5,0.5) (-9,9,0) end vertexs begin faces (0,1,2,3) end faces end "
    "mesh";

class EffectMeasurements : public testing::Test {
 protected:
  options::RenderOptions options_of(const std::string& scene) const {
    options::RenderOptions result;
    result.scene = folder_.add("scene.grf", scene);
    result.size = {400, 300};
    result.eye = grf::Vec3f(0, 0, 0.9F);
    result.target = grf::Vec3f(0);
    return result;
  }

  std::map<Effect, MeasuredEffect> measured(const options::RenderOptions& options, double seconds = 0.5) {
    grf::Diagnostics diagnostics;
    const auto scene = job::read_scene(options, diagnostics);
    const auto settings = job::compile_settings_of(options, diagnostics);
    const auto planned = job::render_plan(*scene, *settings, options, diagnostics);
    std::map<Effect, MeasuredEffect> results;
    job::EffectMeasurement measurement(options, planned->plan, {.seconds = seconds},
                                       [&](const MeasuredEffect& one) { results.emplace(one.effect, one); });
    measurement.run();
    EXPECT_FALSE(measurement.diagnostics().has_errors()) << measurement.diagnostics().to_text();
    EXPECT_EQ(results.size(), measurement.effect_count());
    EXPECT_EQ(measurement.size(), (options::ImageSize{160, 120}));
    return results;
  }

  test::TemporaryFolder folder_;
};

// The residuals are 0.1 of the mean, so their deviation is sqrt(4 0.01 / 3); the 97.5 % quantile of t with
// 3 degrees of freedom is 3.182 (Abramowitz and Stegun, table 26.10).
TEST(LostShare, HasAnIntervalByStudentsDistribution) {
  const std::array with = {1.0, 1.0, 1.0, 1.0};
  const std::array without = {0.4, 0.6, 0.4, 0.6};
  const auto share = job::lost_share(with, without);
  ASSERT_TRUE(share);
  EXPECT_NEAR(share->value, 0.5, 1e-12);
  EXPECT_NEAR(share->high - share->value, 3.182 * std::sqrt(0.04 / 3 / 4), 0.002);
  EXPECT_NEAR(share->high + share->low, 1, 1e-12);
  EXPECT_FALSE(job::lost_share(std::array{0.0, 0.0}, std::array{0.0, 0.0})) << "a black image";
}

// Rounds that are brighter as a whole say nothing against the ratio.
TEST(LostShare, IsExactIfPairsAreProportional) {
  const auto share = job::lost_share(std::array{1.0, 2.0, 5.0}, std::array{0.75, 1.5, 3.75});
  ASSERT_TRUE(share);
  EXPECT_NEAR(share->value, 0.25, 1e-12);
  EXPECT_NEAR(share->low, 0.25, 1e-12);
}

// In a closed diffuse box of albedo 1/2 bounce k adds 1/2^k to the radiance 1 that is emitted: up to bounce 5
// that is 63/32, of which bounces 2 to 5 are 15/32.
TEST_F(EffectMeasurements, OfAFurnaceAreTheGeometricSeries) {
  const auto effects = measured(options_of(Furnace));
  ASSERT_EQ(effects.size(), 2U);
  const MeasuredEffect& interreflection = effects.at(Effect::DiffuseInterreflection);
  ASSERT_TRUE(interreflection.light);
  EXPECT_NEAR(interreflection.light->value, 15.0 / 63, 0.01);
  EXPECT_GT(interreflection.light->high, 15.0 / 63 - 0.004);
  EXPECT_LT(interreflection.light->low, 15.0 / 63 + 0.004);
  EXPECT_NEAR(*interreflection.difference, 15.0 / 63, 0.02) << "it is the same at all pixels";
  ASSERT_TRUE(interreflection.time);
  EXPECT_GT(interreflection.time->value, 0.1) << "five bounces cost more than one";
  EXPECT_LT(interreflection.time->value, 1);
  EXPECT_NEAR(interreflection.full.at(80, 60).x, 63.0 / 32, 0.3);
  EXPECT_NEAR(interreflection.without.at(80, 60).x, 48.0 / 32, 0.2);
  const MeasuredEffect& lamps = effects.at(Effect::AreaLights);
  ASSERT_TRUE(lamps.light);
  EXPECT_EQ(lamps.light->value, 1) << "without them the image is black";
  EXPECT_EQ(lamps.light->low, 1);
}

// Without vertex colours the plane is twice as bright: the loss is minus the whole image.
TEST_F(EffectMeasurements, AreNegativeIfTheImageGetsBrighter) {
  options::RenderOptions options = options_of(GreyedPlane);
  options.background = grf::Vec3f(1);
  const auto effects = measured(options);
  ASSERT_TRUE(effects.contains(Effect::VertexColours));
  EXPECT_NEAR(effects.at(Effect::VertexColours).light->value, -1, 0.02);
  EXPECT_NEAR(*effects.at(Effect::VertexColours).difference, 1, 0.02);
  EXPECT_EQ(effects.at(Effect::Background).light->value, 1);
}

// The options switch one off: it is neither rendered nor measured.
TEST_F(EffectMeasurements, AreOfWhatIsSwitchedOn) {
  options::RenderOptions options = options_of(Furnace);
  options.without = {"indirect"};
  const auto effects = measured(options, 0.1);
  ASSERT_EQ(effects.size(), 1U);
  EXPECT_TRUE(effects.contains(Effect::AreaLights));
}

}  // namespace
