#include "renderer/farm/division.h"

#include <algorithm>
#include <map>
#include <tuple>

#include <gtest/gtest.h>

namespace {

using farm::divide;
using farm::Stage;
using farm::Task;
using farm::TaskLimits;

/// A stage in which all tiles have samples of both halves from `first` up to `end`.
Stage stage_of(int tiles, std::uint32_t first, transport::FilmTile::Counts end) {
  Stage stage;
  stage.samples.assign(static_cast<std::size_t>(tiles), {{first, first}, end});
  return stage;
}

std::vector<Task> divide(int tiles, transport::FilmTile::Counts end, double seconds_per_sample,
                         const TaskLimits& limits) {
  return farm::divide(stage_of(tiles, 0, end), 0, seconds_per_sample, limits);
}

/// Counts how often tasks have each sample of each half of each tile, and expects once.
void expect_each_sample_once(const std::vector<Task>& tasks, const Stage& stage) {
  std::map<std::tuple<std::size_t, std::size_t, std::uint32_t>, int> counts;
  for (const Task& task : tasks) {
    std::uint32_t samples = 0;
    for (std::size_t i = 0; i < task.samples.size(); ++i) {
      for (std::size_t half = 0; half < 2; ++half) {
        for (auto number = task.samples[i].first[half]; number < task.samples[i].end[half]; ++number) {
          ++counts[{static_cast<std::size_t>(task.first_tile) + i, half, number}];
          ++samples;
        }
      }
    }
    EXPECT_GT(samples, 0U) << "task " << task.number;
  }
  std::size_t wanted = 0;
  for (std::size_t tile = 0; tile < stage.samples.size(); ++tile) {
    for (std::size_t half = 0; half < 2; ++half) {
      const auto& own = stage.samples[tile];
      for (auto number = own.first[half]; number < own.end[half]; ++number, ++wanted) {
        EXPECT_EQ((counts[{tile, half, number}]), 1) << tile << " " << half << " " << number;
      }
    }
  }
  EXPECT_EQ(counts.size(), wanted);
}

// A tile has 256 pixels: at 10 samples of 1/2560 s each, it takes a second.
TEST(Division, TakesTilesForTheTimeOfATask) {
  const auto tasks = divide(12, {5, 5}, 1.0 / 2560, {.seconds = 3.5, .bytes = 1U << 30U});
  EXPECT_EQ(tasks.size(), 4U) << "12 tiles, 3 a task";
  EXPECT_EQ(tasks[1].number, 1);
  EXPECT_EQ(tasks[1].first_tile, 3);
  EXPECT_EQ(tasks[1].samples.size(), 3U);
  expect_each_sample_once(tasks, stage_of(12, 0, {5, 5}));
}

TEST(Division, DividesTheSamplesOfATileThatTakesLong) {
  const auto tasks = divide(2, {5, 5}, 1.0 / 2560, {.seconds = 0.3, .bytes = 1U << 30U});
  EXPECT_EQ(tasks.size(), 8U) << "2 tiles, and 1/0.3 ranges of each";
  expect_each_sample_once(tasks, stage_of(2, 0, {5, 5}));
  const auto single = divide(2, {2, 1}, 1, {.seconds = 0.1, .bytes = 1U << 30U});
  EXPECT_EQ(single.size(), 6U) << "no range is less than a sample";
  expect_each_sample_once(single, stage_of(2, 0, {2, 1}));
}

// As adaptive sampling places them: some tiles take much, and some nothing.
TEST(Division, HasEachSampleOnceWhereTilesDiffer) {
  Stage stage = stage_of(9, 16, {16, 16});
  stage.samples[1].end = {18, 17};
  stage.samples[2].end = {316, 20};
  stage.samples[5].end = {16, 417};
  stage.samples[8].end = {20, 20};
  const auto tasks = farm::divide(stage, 70, 1.0 / 2560, {.seconds = 2, .bytes = 1U << 30U});
  expect_each_sample_once(tasks, stage);
  EXPECT_EQ(tasks.front().number, 70);
  EXPECT_EQ(tasks.back().number, 70 + static_cast<int>(tasks.size()) - 1);
  EXPECT_TRUE(farm::divide(stage_of(4, 3, {3, 3}), 0, 1, {}).empty());
}

// One process compares the samples of a tile's pilot with each other.
TEST(Division, KeepsThePilotOfATileTogether) {
  Stage stage = stage_of(3, 0, {16, 16});
  stage.is_pilot = true;
  const auto tasks = farm::divide(stage, 0, 1, {.seconds = 0.1, .bytes = 1U << 30U});
  EXPECT_EQ(tasks.size(), 3U);
  EXPECT_TRUE(tasks.front().is_pilot);
  expect_each_sample_once(tasks, stage);
}

// A pixel has 96 bytes.
TEST(Division, KeepsPartsBelowTheSizeOfAMessage) {
  constexpr std::size_t Bytes = 1U << 20U;
  const auto tasks = divide(1200, {2, 2}, 1e-9, {.seconds = 2, .bytes = Bytes});
  expect_each_sample_once(tasks, stage_of(1200, 0, {2, 2}));
  for (const Task& task : tasks) {
    const std::size_t bytes = task.samples.size() * 256 * 96;
    EXPECT_LE(bytes, Bytes);
    if (&task != &tasks.back()) {
      EXPECT_GT(bytes, Bytes * 9 / 10);
    }
  }
  const auto each = divide(1200, {2, 2}, 1e-9, {.seconds = 2, .bytes = 100});
  EXPECT_EQ(each.size(), 1200U);
  expect_each_sample_once(each, stage_of(1200, 0, {2, 2}));
}

}  // namespace
