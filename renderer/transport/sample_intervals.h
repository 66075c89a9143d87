// Sets of sample numbers are lists of intervals.
#pragma once

#include <cstdint>
#include <vector>

namespace transport {

/// Consecutive samples of a half of a tile, by number.
struct SampleInterval {
  std::uint32_t first = 0;
  std::uint32_t end = 0;  ///< behind the last one

  bool operator==(const SampleInterval&) const = default;
};

/// A set of samples: intervals in ascending order, none of them empty, with a gap between any two.
using SampleIntervals = std::vector<SampleInterval>;

/// Returns the number of samples.
std::uint32_t count_of(const SampleIntervals& intervals);

/// Returns whether two sets have samples in common.
bool overlap(const SampleIntervals& a, const SampleIntervals& b);

/// Returns the samples of both sets, which have none in common.
SampleIntervals joined(const SampleIntervals& a, const SampleIntervals& b);

/// Returns the samples of a set that another has not.
SampleIntervals without(const SampleIntervals& all, const SampleIntervals& some);

}  // namespace transport
