// A run of rejection sampling records its tries.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <vector>

namespace studies {

/// A try of rejection sampling: a place, and a height between 0 and the bound.
template <class Place>
struct Try {
  Place place;
  double height = 0;
  bool is_accepted = false;
};

struct RunLimits {
  std::size_t samples = 0;  ///< how many are wanted
  std::function<bool()> is_stopped = {};

  /// The run ends after so many tries, with fewer samples.
  static constexpr std::size_t MostTries = 1'000'000;
  /// The first tries are recorded.
  static constexpr std::size_t MostRecorded = 3000;
  /// Tries between two polls of `is_stopped`.
  static constexpr std::size_t PollEvery = 4096;
};

/// The outcome of a run of rejection sampling.
template <class Place>
struct Run {
  std::vector<Place> accepted;
  std::vector<Try<Place>> recorded;
  std::size_t tries = 0;
  std::size_t above = 0;  ///< tries where the function exceeds the bound, which is too low then
  double seconds = 0;

  double acceptance() const {
    return tries > 0 ? static_cast<double>(accepted.size()) / static_cast<double>(tries) : 0;
  }
};

/// Samples by rejection: `propose` returns a place, `bound_of` the bound there, `value` the function, and
/// `uniform` numbers in [0,1). `propose` is told whether the last place was accepted.
template <class Place, class Propose, class BoundOf, class Value, class Uniform>
Run<Place> reject(const RunLimits& limits, Propose propose, BoundOf bound_of, Value value, Uniform uniform) {
  Run<Place> run;
  run.accepted.reserve(limits.samples);
  run.recorded.reserve(RunLimits::MostRecorded);
  const auto start = std::chrono::steady_clock::now();
  bool is_accepted = true;
  while (run.accepted.size() < limits.samples && run.tries < RunLimits::MostTries) {
    if (run.tries % RunLimits::PollEvery == 0 && limits.is_stopped && limits.is_stopped()) break;
    const Place place = propose(is_accepted);
    const double bound = bound_of();
    const double height = uniform() * bound;
    const double at_place = value(place);
    is_accepted = height < at_place;
    ++run.tries;
    run.above += at_place > bound ? 1 : 0;
    if (is_accepted) run.accepted.push_back(place);
    if (run.recorded.size() < RunLimits::MostRecorded) run.recorded.push_back({place, height, is_accepted});
  }
  run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return run;
}

}  // namespace studies
