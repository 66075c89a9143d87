// Renders that are looked at and stopped by other threads.
#include <set>
#include <thread>

#include <gtest/gtest.h>

#include "tests/transport/sample_scenes.h"

namespace {

using transport::FilmTile;
using transport::Render;
using transport::RenderEnd;
using transport::RenderSettings;

RenderSettings settings(int samples) {
  test::Look look = test::look_at_floor(70, 50, samples);
  look.threads = 2;
  return test::settings_of(look);
}

TEST(SampleScenes, GiveTheSameImageForAnyNumberOfThreads) {
  for (const std::string& path : test::sample_op_files()) {
    test::SampleScene sample = test::sample_scene(path);
    std::vector<transport::Image> images;
    for (const int threads : {1, 2, 7}) {
      sample.settings.threads = threads;
      Render render(sample.scene, sample.settings);
      render.run();
      images.push_back(render.film().mean());
      EXPECT_EQ(images.back().pixels, images.front().pixels) << path << ", " << threads << " threads";
    }
  }
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

// Half a tile of new samples in one pixel and not in another would show as different counts of light.
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
  std::vector<transport::Image> images;
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
  // Between t^-1/2 and t^-1 is what the error may do.
  const double ratio = *progress.estimated_error / 1e-4;
  EXPECT_GT(*progress.seconds_left, 0.5 * ratio * progress.seconds);
  EXPECT_LT(*progress.seconds_left, 2 * ratio * ratio * progress.seconds);
  EXPECT_EQ(render.end(), RenderEnd::Stopped);
  EXPECT_LT(render.progress().done, 1);
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

TEST(TileQueue, CutsAllWorkIntoPiecesOfWhichNoneIsGivenTwice) {
  transport::Film film(100, 70);
  for (const int threads : {1, 5, 64}) {
    transport::TileQueue queue(film, 45, threads);
    std::vector<int> samples(static_cast<std::size_t>(film.tile_count()));
    int spread = 0;
    while (const auto work = queue.take()) {
      int& present = samples[static_cast<std::size_t>(work->tile)];
      ASSERT_EQ(work->first, present);
      ASSERT_GT(work->last, work->first);
      present = work->last;
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
