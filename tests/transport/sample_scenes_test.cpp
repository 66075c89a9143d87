// Both integrators agree on each of the sample scenes, all over the image, which does not depend on threads
// and interruptions.
#include "tests/transport/sample_scenes.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>

#include <gtest/gtest.h>

#include "tests/statistics/chi_square.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/thoroughness.h"
#include "tests/transport/block_statistics.h"
#include "tests/transport/interrupted_render.h"

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

/// Returns the first two scenes of each folder, or all in a long run.
std::vector<std::string> scenes() {
  std::vector<std::string> files = test::sample_op_files();
  if (test::tries_all()) return files;
  std::map<std::filesystem::path, int> counts;
  std::erase_if(files, [&](const std::string& file) {
    return ++counts[std::filesystem::path(file).parent_path()] > 2;
  });
  return files;
}

INSTANTIATE_TEST_SUITE_P(Scenes, SampleScenes, testing::ValuesIn(scenes()),
                         [](const auto& tested) { return test::name_of(tested.param); });

class SampleImages : public testing::TestWithParam<std::string> {};

TEST_P(SampleImages, AreTheSameForAnyNumberOfThreadsAndResumed) {
  const test::SampleScene sample = test::sample_scene(GetParam());
  constexpr transport::Fingerprint OfImage = {{1}, {2}, {3}};
  const test::TemporaryFolder folder;
  RenderSettings settings = sample.settings;
  image::Image first;
  for (const int threads : {1, 2, 7}) {
    SCOPED_TRACE(std::to_string(threads) + " threads");
    settings.threads = threads;
    transport::Render render(sample.scene, settings);
    render.run();
    if (threads == 1) first = render.film().mean();
    EXPECT_EQ(render.film().mean().pixels, first.pixels);
    const std::string checkpoint = folder.path(std::to_string(threads));
    for (const std::uint64_t paths : {300U, 4000U}) {
      test::render_part(sample.scene, settings, paths, checkpoint, OfImage);
    }
    EXPECT_EQ(test::resumed(sample.scene, settings, checkpoint, OfImage).pixels, first.pixels);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, SampleImages, testing::ValuesIn(test::sample_op_files()),
                         [](const auto& tested) { return test::name_of(tested.param); });

}  // namespace
