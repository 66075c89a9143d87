#include "renderer/transport/sample_intervals.h"

#include <algorithm>
#include <iterator>
#include <set>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "renderer/transport/adaptive_sampling.h"
#include "renderer/transport/image_part.h"

namespace {

using transport::FilmTile;
using transport::ImagePart;
using transport::SampleIntervals;
using transport::TileSamples;
using NumberSet = std::set<std::uint32_t>;

SampleIntervals intervals_of(const NumberSet& numbers) {
  SampleIntervals intervals;
  for (const std::uint32_t number : numbers) {
    if (intervals.empty() || intervals.back().end != number) intervals.push_back({number, number});
    intervals.back().end = number + 1;
  }
  return intervals;
}

NumberSet random_numbers() {
  return *rc::gen::container<NumberSet>(rc::gen::inRange<std::uint32_t>(0, 40)).as("numbers");
}

RC_GTEST_PROP(SampleIntervals, AreSets, ()) {
  const NumberSet a = random_numbers();
  const NumberSet b = random_numbers();
  NumberSet common;
  NumberSet rest;
  NumberSet both;
  std::ranges::set_intersection(a, b, std::inserter(common, common.end()));
  std::ranges::set_difference(a, b, std::inserter(rest, rest.end()));
  std::ranges::set_union(rest, b, std::inserter(both, both.end()));
  RC_ASSERT(overlap(intervals_of(a), intervals_of(b)) == !common.empty());
  RC_ASSERT(without(intervals_of(a), intervals_of(b)) == intervals_of(rest));
  RC_ASSERT(joined(intervals_of(rest), intervals_of(b)) == intervals_of(both));
  RC_ASSERT(count_of(intervals_of(a)) == a.size());
}

// Any number of parts has each sample exactly once, and equally many but for rounding: the sum over many
// tiles differs by little.
RC_GTEST_PROP(ImageParts, DivideTheSamples, ()) {
  const int tiles = *rc::gen::inRange(1, 60);
  const int parts = *rc::gen::inRange(1, 90);
  const int samples = *rc::gen::inRange(1, 200);
  const int first = *rc::gen::inRange(0, samples);
  const std::vector<FilmTile::Counts> counts(static_cast<std::size_t>(tiles),
                                             transport::uniform_counts(samples));
  std::vector<TileSamples> next =
      transport::samples_of({.first_sample = first, .end_sample = first + 1, .index = 0, .count = 1}, counts);
  double all = 0;
  std::vector<double> sizes;
  for (int index = 0; index < parts; ++index) {
    const auto own = transport::samples_of({.first_sample = first, .index = index, .count = parts}, counts);
    double size = 0;
    for (std::size_t tile = 0; tile < own.size(); ++tile) {
      RC_ASSERT(own[tile].first == next[tile].first);
      for (std::size_t half = 0; half < 2; ++half) {
        RC_ASSERT(own[tile].end[half] >= own[tile].first[half]);
        size += own[tile].end[half] - own[tile].first[half];
      }
      next[tile].first = own[tile].end;
    }
    sizes.push_back(size);
    all += size;
  }
  RC_ASSERT(all == double(samples - first) * tiles);
  for (std::size_t tile = 0; tile < next.size(); ++tile) RC_ASSERT(next[tile].first == counts[tile]);
  // The golden ratio's sequence has a discrepancy of about log n / n.
  const double mean = all / parts;
  const double tolerance = 2 + 2 * std::log(1 + 2.0 * tiles);
  for (const double size : sizes) RC_ASSERT(std::abs(size - mean) < tolerance);
}

TEST(ImageParts, AreOfRanges) {
  const std::vector<FilmTile::Counts> counts(4, transport::uniform_counts(16));
  const auto own = transport::samples_of({5, 10, 1, 3}, counts);
  for (const std::size_t outside : {0U, 3U}) EXPECT_EQ(own[outside].first, own[outside].end);
  for (const std::size_t inside : {1U, 2U}) {
    // Samples 5, 7 and 9 are numbers 2 to 4 of the second half, samples 6 and 8 numbers 3 and 4 of the first.
    EXPECT_EQ(own[inside].first, (FilmTile::Counts{3, 2}));
    EXPECT_EQ(own[inside].end, (FilmTile::Counts{5, 5}));
  }
}

}  // namespace
