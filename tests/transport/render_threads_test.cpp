// Renders that other threads observe and stop.
#include <set>
#include <thread>

#include <gtest/gtest.h>

#include "tests/transport/scene_helpers.h"

namespace {

using transport::FilmTile;
using transport::Render;
using transport::RenderEnd;
using transport::RenderSettings;

RenderSettings settings(int samples) {
  test::RenderSetup setup = test::floor_setup(70, 50, samples);
  setup.threads = 2;
  return test::settings_of(setup);
}

TEST(Snapshot, IsTheImageSoFarWhileWorkersGoOn) {
  const auto scene = test::scene_of(test::LitFloor);
  Render render(scene, settings(300));
  std::thread worker([&] { render.run(); });
  int snapshots = 0;
  FilmTile tile;
  for (std::uint32_t last = 0; render.end() == RenderEnd::NotYet; ++snapshots) {
    const transport::Snapshot snapshot = render.snapshot(true);
    ASSERT_EQ(snapshot.mean.pixels.size(), 70U * 50U);
    ASSERT_EQ(snapshot.variance.pixels.size(), 70U * 50U);
    render.copy_tile(0, tile);
    ASSERT_GE(tile.sample_count(), last);
    last = tile.sample_count();
    const transport::RenderProgress progress = render.progress();
    ASSERT_TRUE(progress.done >= 0 && progress.done <= 1);
  }
  worker.join();
  EXPECT_GT(snapshots, 1);
  EXPECT_EQ(render.snapshot().mean.pixels, render.film().mean().pixels);
  EXPECT_TRUE(render.snapshot().variance.pixels.empty());
  EXPECT_EQ(render.snapshot(true).variance.pixels, render.film().variance().pixels);
}

// Half a tile of new samples would show as different amounts of light in its pixels.
TEST(Snapshot, NeverShowsHalfATile) {
  RenderSettings all_white = settings(2000);
  all_white.integrator.background = transport::Rgb(1);
  const auto scene = test::scene_of(test::quad("brdf diffuse kd=1", "(-9,0,9) (9,0,9) (9,0,-9) (-9,0,-9)"));
  Render render(scene, all_white);
  std::thread worker([&] { render.run(); });
  FilmTile tile;
  while (render.end() == RenderEnd::NotYet) {
    for (int i = 0; i < render.film().tile_count(); ++i) {
      render.copy_tile(i, tile);
      for (std::size_t p = 0; p < tile.pixels.size() && tile.sample_count() > 0; ++p) {
        ASSERT_NEAR(tile.mean(p).x, 1, 1e-3);
      }
    }
    if (render.progress().done > 0.5) render.stop();
  }
  worker.join();
}

TEST(TargetError, StopsAllThreadCountsAtTheSameSample) {
  const auto scene = test::scene_of(test::LitFloor);
  RenderSettings until = settings(RenderSettings::Unlimited);
  until.target_error = 0.02;
  std::set<std::uint32_t> counts;
  std::vector<image::Image> images;
  for (const int threads : {1, 2, 7}) {
    until.threads = threads;
    Render render(scene, until);
    render.run();
    EXPECT_EQ(render.end(), RenderEnd::TargetError);
    EXPECT_LE(*render.film().estimated_error(), 0.02);
    EXPECT_EQ(render.progress().done, 1);
    for (int tile = 0; tile < render.film().tile_count(); ++tile) {
      EXPECT_EQ(render.film().counts_of(tile)[0], render.film().counts_of(tile)[1]);
      counts.insert(render.film().sample_count_of(tile));
    }
    images.push_back(render.film().mean());
  }
  EXPECT_EQ(counts.size(), 1U);
  EXPECT_GE(*counts.begin(), 16U);
  EXPECT_EQ(images[0].pixels, images[1].pixels);
  EXPECT_EQ(images[0].pixels, images[2].pixels);
}

TEST(TargetError, IsNoReasonToExceedTheSamples) {
  const auto scene = test::scene_of(test::LitFloor);
  RenderSettings until = settings(21);
  until.target_error = 1e-6;
  Render render(scene, until);
  render.run();
  EXPECT_EQ(render.end(), RenderEnd::Samples);
  EXPECT_EQ(render.samples_per_pixel(), 21);
}

// A specular ball reflects light to the floor, which paths find by chance.
const transport::CompiledScene& uneven_scene() {
  static const auto scene =
      test::scene_of(test::LitFloor + test::quad("brdf specular", "(-3,0,-3) (3,0,-3) (3,3,-3) (-3,3,-3)"));
  return scene;
}

TEST(AdaptiveSampling, GivesTheSameImageForAnyNumberOfThreads) {
  RenderSettings adaptive = settings(100);
  adaptive.adaptive = true;
  std::vector<image::Image> images;
  for (const int threads : {1, 2, 7}) {
    adaptive.threads = threads;
    Render render(uneven_scene(), adaptive);
    render.run();
    EXPECT_EQ(render.end(), RenderEnd::Samples);
    EXPECT_LE(render.samples_per_pixel(), 100);
    EXPECT_GE(render.samples_per_pixel(), 96);
    std::set<std::uint32_t> counts;
    for (int tile = 0; tile < render.film().tile_count(); ++tile) {
      counts.insert(render.film().sample_count_of(tile));
    }
    EXPECT_GT(counts.size(), 3U);
    EXPECT_GE(*counts.begin(), 32U);
    images.push_back(render.film().mean());
    EXPECT_EQ(images.back().pixels, images.front().pixels) << threads;
  }
}

TEST(AdaptiveSampling, IsUniformForFewSamples) {
  RenderSettings few = settings(21);
  Render uniform(uneven_scene(), few);
  uniform.run();
  few.adaptive = true;
  Render adaptive(uneven_scene(), few);
  adaptive.run();
  EXPECT_EQ(adaptive.film().mean().pixels, uniform.film().mean().pixels);
}

TEST(AdaptiveSampling, ReachesATargetWithFewerSamples) {
  // Most of the image is black.
  const auto scene = test::scene_of(test::LitFloor);
  RenderSettings until = settings(RenderSettings::Unlimited);
  until.target_error = 0.002;
  Render uniform(scene, until);
  uniform.run();
  until.adaptive = true;
  Render adaptive(scene, until);
  adaptive.run();
  EXPECT_EQ(adaptive.end(), RenderEnd::TargetError);
  EXPECT_LE(*adaptive.film().estimated_error(), 0.002);
  EXPECT_LT(adaptive.samples_per_pixel(), uniform.samples_per_pixel());
}

TEST(AdaptiveSampling, StopsInTimeWithAValidImage) {
  RenderSettings until = settings(RenderSettings::Unlimited);
  until.adaptive = true;
  until.max_seconds = 0.3;
  Render render(uneven_scene(), until);
  render.run();
  EXPECT_EQ(render.end(), RenderEnd::Time);
  EXPECT_LT(render.seconds(), 3);
  for (const auto& pixel : render.film().mean().pixels) ASSERT_TRUE(std::isfinite(pixel.x));
}

TEST(MaxTime, StopsWithWhatThereIs) {
  const auto scene = test::scene_of(test::LitFloor);
  RenderSettings until = settings(RenderSettings::Unlimited);
  until.max_seconds = 0.3;
  Render render(scene, until);
  render.run();
  EXPECT_EQ(render.end(), RenderEnd::Time);
  EXPECT_GE(render.seconds(), 0.3);
  EXPECT_LT(render.seconds(), 3);
  EXPECT_GT(render.samples_per_pixel(), 1);
  EXPECT_EQ(render.progress().done, 1);
  EXPECT_EQ(render.progress().seconds_left, 0);
}

TEST(Progress, ForecastsAsTheChecksDo) {
  const auto scene = test::scene_of(test::LitFloor);
  RenderSettings until = settings(RenderSettings::Unlimited);
  until.target_error = 0.004;
  Render render(scene, until);
  EXPECT_TRUE(render.forecasts({0.01}).empty()) << "nothing is known";
  render.run();
  const double needed = render.checks().back().samples;
  const auto forecasts = render.forecasts({0.02, 0.004, 0.001});
  ASSERT_EQ(forecasts.size(), 3U);
  EXPECT_EQ(forecasts[1].samples.median, needed) << "it was reached";
  EXPECT_LE(forecasts[0].samples.median, needed);
  EXPECT_GT(forecasts[2].samples.low, needed);
  EXPECT_NEAR(forecasts[1].seconds.median, render.seconds(), 0.01 * render.seconds());
}

TEST(Progress, KnowsTheTimeToATarget) {
  const auto scene = test::scene_of(test::LitFloor);
  RenderSettings until = settings(RenderSettings::Unlimited);
  until.target_error = 1e-4;
  Render render(scene, until);
  std::thread worker([&] { render.run(); });
  while (render.samples_per_pixel() < 40) std::this_thread::yield();
  const transport::RenderProgress progress = render.progress();
  render.stop();
  worker.join();
  ASSERT_TRUE(progress.estimated_error && progress.seconds_left);
  // The error falls between t^-1/2 and t^-1.
  const double ratio = *progress.estimated_error / 1e-4;
  EXPECT_GT(*progress.seconds_left, 0.5 * ratio * progress.seconds);
  EXPECT_LT(*progress.seconds_left, 2 * ratio * ratio * progress.seconds);
  EXPECT_EQ(render.end(), RenderEnd::Stopped);
  EXPECT_LT(render.progress().done, 1);
}

RenderSettings probe_settings() {
  RenderSettings probe = settings(RenderSettings::Unlimited);
  probe.width = 160;  // 10 x 8 tiles
  probe.height = 128;
  probe.probe = {20, 0};
  return probe;
}

TEST(Probe, RendersSomeTilesSpreadOverTheImage) {
  const auto scene = test::scene_of(test::LitFloor);
  Render probe(scene, probe_settings());
  probe.run();
  EXPECT_EQ(probe.end(), RenderEnd::Time);
  ASSERT_EQ(probe.checks().size(), 1U) << "the first one after the time";
  EXPECT_EQ(probe.samples_per_pixel(), 16);
  EXPECT_EQ(probe.rendered_fraction(), 0.25);
  std::array<int, 4> in_quarter = {};
  for (int tile = 0; tile < 80; ++tile) {
    const std::uint32_t samples = probe.film().sample_count_of(tile);
    EXPECT_TRUE(samples == 0 || samples == 16) << samples;
    const int quarter = tile % 10 / 5 + 2 * (tile / 40);
    in_quarter[static_cast<std::size_t>(quarter)] += samples > 0 ? 1 : 0;
  }
  for (const int tiles : in_quarter) EXPECT_NEAR(tiles, 5, 2);
}

TEST(Probe, EstimatesTheErrorAndTheCostOfTheWholeImage) {
  RenderSettings all = probe_settings();
  all.probe->seconds = 0.05;
  Render probe(uneven_scene(), all);
  probe.run();
  all.probe->tiles = 80;
  all.probe->seconds = 0;
  Render whole(uneven_scene(), all);
  whole.run();
  ASSERT_EQ(whole.rendered_fraction(), 1);
  const transport::ErrorCheck part = probe.checks().front();
  const transport::ErrorCheck truth = whole.checks().front();
  EXPECT_EQ(truth.sampling_deviation, 0);
  EXPECT_GT(part.sampling_deviation, 0.01);
  EXPECT_LT(std::abs(std::log(part.estimate.error / truth.estimate.error)),
            3 * part.sampling_deviation + 0.05);
  // As if the error were spread over the whole image: the interval is no wider than that of all tiles.
  EXPECT_NEAR(std::log(part.estimate.high / part.estimate.low),
              std::log(truth.estimate.high / truth.estimate.low), 0.2);
  EXPECT_GT(part.seconds / probe.rendered_fraction(), truth.seconds / 3);
  EXPECT_LT(part.seconds / probe.rendered_fraction(), truth.seconds * 3);
}

TEST(Probe, SamplesAdaptivelyAsTheImageDoes) {
  RenderSettings adaptive = probe_settings();
  adaptive.adaptive = true;
  adaptive.samples = 100;
  adaptive.probe->seconds = 1e9;
  Render probe(uneven_scene(), adaptive);
  probe.run();
  EXPECT_EQ(probe.end(), RenderEnd::Samples);
  EXPECT_LE(probe.samples_per_pixel(), 100);
  EXPECT_GE(probe.samples_per_pixel(), 94);
  std::set<std::uint32_t> counts;
  int tiles = 0;
  for (int tile = 0; tile < 80; ++tile) {
    const std::uint32_t samples = probe.film().sample_count_of(tile);
    if (samples > 0) counts.insert(samples);
    tiles += samples > 0 ? 1 : 0;
  }
  EXPECT_EQ(tiles, 20);
  EXPECT_GE(*counts.begin(), 32U);
  EXPECT_GT(counts.size(), 3U);
}

TEST(RejectedSamples, AreCountedWithTheFirstPixel) {
  RenderSettings broken = settings(4);
  broken.integrator.background = transport::Rgb(std::numeric_limits<float>::infinity());
  const auto scene = test::scene_of(test::FloorLight +
                                    test::quad("brdf diffuse kd=0", "(-9,-9,0) (9,-9,0) (9,9,0) (-9,9,0)"));
  broken.view.eye = transport::Vec3f(0, 9.5F, 5);  // sees over the edge of the quad, in the upper half
  broken.view.target = transport::Vec3f(0, 9.5F, 0);
  Render render(scene, broken);
#ifdef NDEBUG
  render.run();
  EXPECT_EQ(render.totals().first_rejected, 0U);
  EXPECT_GT(render.rejected_samples(), 70U * 20U * 4U);
  EXPECT_LT(render.rejected_samples(), 70U * 40U * 4U);
  for (const auto& pixel : render.film().mean().pixels) ASSERT_TRUE(std::isfinite(pixel.x));
#else
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_DEATH(render.run(), "a sample is not finite");
#endif
}

/// Returns why the first non-finite sample is not finite.
transport::NotFinite cause(const transport::CompiledScene& scene, const RenderSettings& broken) {
  Render render(scene, broken);
#ifdef NDEBUG
  render.run();
  EXPECT_GT(render.rejected_samples(), 0U);
  for (const auto& pixel : render.film().mean().pixels) EXPECT_TRUE(std::isfinite(pixel.x));
  return render.cause_of_rejection().value_or(transport::NotFinite());
#else
  EXPECT_DEATH(render.run(), "a sample is not finite");
  return {};
#endif
}

void expect_cause(const transport::NotFinite& found, std::string_view term, bool is_somewhere) {
#ifdef NDEBUG
  EXPECT_EQ(found.term, term);
  EXPECT_EQ(found.where.has_value(), is_somewhere);
#else
  EXPECT_TRUE(found.term.empty()) << term << is_somewhere;
#endif
}

TEST(RejectedSamples, HaveACause) {
#ifndef NDEBUG
  testing::FLAGS_gtest_death_test_style = "threadsafe";
#endif
  const float infinity = std::numeric_limits<float>::infinity();
  const auto scene = test::scene_of(test::LitFloor);
  RenderSettings broken = settings(4);
  broken.integrator.background = transport::Rgb(infinity);
  expect_cause(cause(scene, broken), "background", false);
  broken.backplate = std::make_shared<image::Image>(
      image::Image{1, 1, {transport::Rgb(std::numeric_limits<float>::quiet_NaN())}});
  broken.integrator.background = transport::Rgb(0);
  expect_cause(cause(scene, broken), "backplate", false);
  broken.integrator.integrator = transport::Integrator::Naive;
  broken.integrator.secondary_rays = 4;
  expect_cause(cause(scene, broken), "backplate", false);
  // The light's and the floor's values are finite, but not their product.
  const auto bright =
      test::scene_of("light begin rgb (3e38,3e38,3e38) (-1,3,-1) (2,0,0) (0,0,2) end\n" +
                     test::quad("rgb (99,99,99) brdf diffuse kd=0.7", "(-3,0,3) (3,0,3) (3,0,-3) (-3,0,-3)"));
  expect_cause(cause(bright, settings(4)), "", false);
}

TEST(RejectedSamples, HaveNoCauseIfThereAreNone) {
  const auto scene = test::scene_of(test::LitFloor);
  Render render(scene, settings(4));
  render.run();
  EXPECT_FALSE(render.cause_of_rejection());
}

TEST(TileQueue, CutsAllWorkIntoPiecesOfWhichNoneIsGivenTwice) {
  transport::Film film(100, 70);
  for (const int threads : {1, 5, 64}) {
    std::vector<int> samples(static_cast<std::size_t>(film.tile_count()));
    transport::TileQueue queue(film, std::vector(samples.size(), transport::uniform_counts(45)), threads);
    int spread = 0;
    while (const auto work = queue.take()) {
      int& present = samples[static_cast<std::size_t>(work->tile)];
      ASSERT_EQ(work->first, transport::uniform_counts(present));
      const int last = static_cast<int>(work->last[0] + work->last[1]);
      ASSERT_GT(last, present);
      present = last;
      ASSERT_EQ(work->last, transport::uniform_counts(present));
      const auto [least, most] = std::minmax_element(samples.begin(), samples.end());
      spread = std::max(spread, *most - *least);
      ASSERT_FALSE(queue.is_finished());
      queue.done(*work);
    }
    EXPECT_TRUE(queue.is_finished());
    EXPECT_EQ(std::set<int>(samples.begin(), samples.end()), std::set<int>{45});
    EXPECT_LE(spread, 16);
  }
}

TEST(TileQueue, StartsAtTheCentreAndGoesFromNeighbourToNeighbour) {
  const transport::Film film(16 * 9, 16 * 7);
  const std::vector<int> tiles = transport::tiles_from_the_centre(film);
  EXPECT_EQ(tiles.front(), 3 * 9 + 4);
  EXPECT_EQ(std::set<int>(tiles.begin(), tiles.end()).size(), 63U);
}

}  // namespace
