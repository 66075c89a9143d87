#include "renderer/farm/division.h"

#include <algorithm>
#include <map>
#include <tuple>

#include <gtest/gtest.h>

namespace {

using farm::divide;
using farm::TaskLimits;
using transport::ImagePart;

/// Counts how often tasks have each sample of each tile, and expects once.
void expect_each_sample_once(const std::vector<ImagePart>& tasks, int tiles, int samples) {
  std::map<std::pair<int, int>, int> counts;
  for (const ImagePart& part : tasks) {
    EXPECT_EQ(part.count, 1);
    for (int tile = part.first_tile; tile < part.end_tile; ++tile) {
      for (int sample = part.first_sample; sample < part.end_sample; ++sample) ++counts[{tile, sample}];
    }
  }
  EXPECT_EQ(counts.size(), static_cast<std::size_t>(tiles * samples));
  EXPECT_TRUE(std::ranges::all_of(counts, [](const auto& count) { return count.second == 1; }));
  EXPECT_EQ(std::prev(counts.end())->first, std::pair(tiles - 1, samples - 1));
}

// A tile has 256 pixels: at 10 samples of 1/2560 s each, it takes a second.
TEST(Division, TakesTilesForTheTimeOfATask) {
  const auto tasks = divide(64, 33, 10, 1.0 / 2560, {.seconds = 3.5, .bytes = 1U << 30U});
  EXPECT_EQ(tasks.size(), 4U) << "12 tiles, 3 a task";
  EXPECT_EQ(tasks.front(), (ImagePart{0, 10, 0, 3}));
  expect_each_sample_once(tasks, 12, 10);
}

TEST(Division, DividesTheSamplesOfATileThatTakesLong) {
  const auto tasks = divide(20, 10, 10, 1.0 / 2560, {.seconds = 0.3, .bytes = 1U << 30U});
  EXPECT_EQ(tasks.size(), 8U) << "2 tiles, and 1/0.3 ranges of each";
  expect_each_sample_once(tasks, 2, 10);
  const auto single = divide(20, 10, 3, 1, {.seconds = 0.1, .bytes = 1U << 30U});
  EXPECT_EQ(single.size(), 6U) << "no range is less than a sample";
  expect_each_sample_once(single, 2, 3);
}

// A pixel has 96 bytes.
TEST(Division, KeepsPartsBelowTheSizeOfAMessage) {
  constexpr std::size_t Bytes = 1U << 20U;
  const auto tasks = divide(640, 480, 4, 1e-9, {.seconds = 2, .bytes = Bytes});
  expect_each_sample_once(tasks, 1200, 4);
  for (const ImagePart& part : tasks) {
    const std::size_t bytes = static_cast<std::size_t>(part.end_tile - part.first_tile) * 256 * 96;
    EXPECT_LE(bytes, Bytes);
    if (part.end_tile != 1200) {
      EXPECT_GT(bytes, Bytes * 9 / 10);
    }
  }
  expect_each_sample_once(divide(640, 480, 4, 1e-9, {.seconds = 2, .bytes = 100}), 1200, 4);
}

}  // namespace
