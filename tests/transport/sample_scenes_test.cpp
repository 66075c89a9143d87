// The two integrators show the same light in each of the sample scenes.
#include "tests/transport/sample_scenes.h"

#include <gtest/gtest.h>

namespace {

class SampleScenes : public testing::TestWithParam<std::string> {};

test::Estimate mean_of(const transport::CompiledScene& scene, const transport::RenderSettings& settings) {
  transport::Render render(scene, settings);
  render.run();
  EXPECT_EQ(render.rejected_samples(), 0U);
  return test::mean_radiance(render.film());
}

// One samples the lights and the BRDFs by the scene's schemes, the other has rays by cosine and mirror alone,
// which cover every BRDF, and meets the lights by chance.
TEST_P(SampleScenes, LookTheSameByNaiveAndByPath) {
  test::SampleScene sample = test::sample_scene(GetParam());
  sample.settings.width = 32;
  sample.settings.height = 24;
  sample.settings.samples = 128;
  const test::Estimate path = mean_of(sample.scene, sample.settings);

  grf::Diagnostics diagnostics;
  const auto by_cosine = grf::read_pdf("diffuse", "test", diagnostics);
  ASSERT_TRUE(by_cosine) << diagnostics.to_text();
  transport::CompileSettings compile_settings;
  compile_settings.scheme = {*by_cosine, {}};
  const test::SampleScene other = test::sample_scene(GetParam(), compile_settings);
  // Most of its noise is in pixels that see the sun in a mirror.
  sample.settings.samples = 640;
  sample.settings.seed = 6;
  sample.settings.integrator.integrator = transport::Integrator::Naive;
  sample.settings.integrator.secondary_rays = 4;
  const test::Estimate naive = mean_of(other.scene, sample.settings);

  // Four deviations, and what the deviations themselves are uncertain by.
  const double deviation = std::hypot(path.deviation, naive.deviation);
  EXPECT_NEAR(path.mean, naive.mean, 5 * deviation);
  EXPECT_LT(path.deviation, 0.01 * path.mean);
  EXPECT_LT(naive.deviation, 0.03 * path.mean);
}

INSTANTIATE_TEST_SUITE_P(Scenes, SampleScenes, testing::ValuesIn(test::sample_op_files()),
                         [](const auto& tested) { return test::sample_name(tested.param); });

}  // namespace
