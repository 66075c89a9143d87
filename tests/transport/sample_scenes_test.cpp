// Both integrators agree on each of the sample scenes, all over the image.
#include "tests/transport/sample_scenes.h"

#include <algorithm>
#include <memory>

#include <gtest/gtest.h>

#include "tests/statistics/chi_square.h"
#include "tests/transport/block_statistics.h"

namespace {

using test::BlockStatistics;
using transport::CompiledScene;
using transport::EnvironmentMap;
using transport::RenderSettings;

BlockStatistics statistics_of(const CompiledScene& scene, RenderSettings settings, int renders) {
  BlockStatistics statistics;
  for (int i = 0; i < renders; ++i) {
    ++settings.seed;
    transport::Render render(scene, settings);
    render.run();
    EXPECT_EQ(render.rejected_samples(), 0U);
    statistics.add(render.film().mean());
  }
  return statistics;
}

/// The map with a sun that rays hit by chance, too: brighter texels are clamped.
std::shared_ptr<const EnvironmentMap> with_dim_sun(const EnvironmentMap& map) {
  constexpr float Brightest = 4;
  image::Image image = map.image();
  for (transport::Rgb& texel : image.pixels) {
    for (int k = 0; k < 3; ++k) texel[k] = std::min(texel[k], Brightest);
  }
  return test::environment_of(std::move(image));
}

class SampleScenes : public testing::TestWithParam<std::string> {
 protected:
  /// Paths with light sampling and the scene's sampling schemes.
  BlockStatistics by_path(int depth) const {
    RenderSettings settings = settings_;
    settings.samples = 32;
    settings.seed = 100;
    settings.integrator.depth = depth;
    return statistics_of(sample_.scene, settings, 10);
  }

  /// Rays that hit the lights by chance.
  BlockStatistics by_chance() const {
    RenderSettings settings = settings_;
    settings.samples = 64;
    settings.seed = 200;
    settings.integrator.integrator = transport::Integrator::Naive;
    settings.integrator.secondary_rays = 4;
    return statistics_of(sample_.scene, settings, 20);
  }

  static RenderSettings small(RenderSettings settings) {
    settings.width = 32;
    settings.height = 24;
    auto& environment = settings.integrator.environment;
    if (environment) environment = with_dim_sun(*environment);
    return settings;
  }

  const test::SampleScene sample_ = test::sample_scene(GetParam());
  const RenderSettings settings_ = small(sample_.settings);
};

// The test can fail: it detects light that is missing where paths end too early.
TEST_P(SampleScenes, LookTheSameByNaiveAndByPath) {
  const BlockStatistics naive = by_chance();
  const double significance =
      statistics::significance(BlockStatistics::Tests * static_cast<int>(test::sample_op_files().size()));
  EXPECT_GT(least_p_value(by_path(settings_.integrator.depth), naive), significance);
  const int too_early = std::min(1, settings_.integrator.depth - 1);
  EXPECT_LT(least_p_value(by_path(too_early), naive), significance) << "depth " << too_early;
}

INSTANTIATE_TEST_SUITE_P(Scenes, SampleScenes, testing::ValuesIn(test::sample_op_files()),
                         [](const auto& tested) { return test::name_of(tested.param); });

}  // namespace
