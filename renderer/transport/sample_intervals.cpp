#include "renderer/transport/sample_intervals.h"

#include <algorithm>
#include <numeric>

namespace transport {

std::uint32_t count_of(const SampleIntervals& intervals) {
  return std::accumulate(intervals.begin(), intervals.end(), 0U,
                         [](std::uint32_t sum, const SampleInterval& i) { return sum + i.end - i.first; });
}

bool overlap(const SampleIntervals& a, const SampleIntervals& b) {
  auto one = a.begin();
  auto other = b.begin();
  while (one != a.end() && other != b.end()) {
    if (one->first < other->end && other->first < one->end) return true;
    if (one->end <= other->first) {
      ++one;
    } else {
      ++other;
    }
  }
  return false;
}

SampleIntervals joined(const SampleIntervals& a, const SampleIntervals& b) {
  SampleIntervals all;
  std::ranges::merge(a, b, std::back_inserter(all), {}, &SampleInterval::first, &SampleInterval::first);
  SampleIntervals result;
  for (const SampleInterval& interval : all) {
    if (!result.empty() && result.back().end == interval.first) {
      result.back().end = interval.end;
    } else {
      result.push_back(interval);
    }
  }
  return result;
}

SampleIntervals without(const SampleIntervals& all, const SampleIntervals& some) {
  SampleIntervals rest;
  auto next = some.begin();
  for (SampleInterval left : all) {
    while (next != some.end() && next->end <= left.first) ++next;
    for (auto taken = next; taken != some.end() && taken->first < left.end; ++taken) {
      if (taken->first > left.first) rest.push_back({left.first, taken->first});
      left.first = std::max(left.first, taken->end);
    }
    if (left.first < left.end) rest.push_back(left);
  }
  return rest;
}

}  // namespace transport
