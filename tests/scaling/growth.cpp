#include "tests/scaling/growth.h"

#include <algorithm>
#include <ctime>

#include <fmt/format.h>

#include "tests/grf/allocation_meter.h"

namespace scaling {
namespace {

/// Shorter ones are mostly noise.
constexpr double LeastSeconds = 1e-3;
/// Less memory than that may be buffers of a fixed size.
constexpr std::size_t LeastBytes = 256U << 10U;
constexpr int MostRepeats = 8;
/// Inputs that begin with fewer have a limit, such as of depth.
constexpr std::size_t LeastUnlimited = 250;

double processor_seconds() {
  timespec time = {};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

Cost cost_of(const Measured& run) {
  const std::size_t bytes_before = grf::allocated_bytes();
  grf::restart_peak();
  const double before = processor_seconds();
  run();
  return {processor_seconds() - before, grf::peak_bytes() - bytes_before};
}

void measure_again(const Measured& run, Cost& cost) {
  const Cost again = cost_of(run);
  cost.seconds = std::min(cost.seconds, again.seconds);
  cost.bytes = std::min(cost.bytes, again.bytes);
}

Growth growth_from(const Measured& first, const Prepare& prepare, std::size_t size) {
  Growth growth;
  growth.size = size;
  const std::array<Measured, 3> runs = {first, prepare(size * 4), prepare(size * 16)};
  for (std::size_t i = 0; i < runs.size(); ++i) growth.costs[i] = cost_of(runs[i]);
  for (int repeat = 1; repeat < MostRepeats && growth.is_too_fast(); ++repeat) {
    for (std::size_t i = 0; i < runs.size(); ++i) measure_again(runs[i], growth.costs[i]);
  }
  return growth;
}

}  // namespace

bool Growth::is_too_fast() const {
  for (std::size_t i = 1; i < costs.size(); ++i) {
    if (costs[i].seconds > MostGrowth * std::max(costs[i - 1].seconds, LeastSeconds)) return true;
    if (static_cast<double>(costs[i].bytes) >
        MostGrowth * static_cast<double>(std::max(costs[i - 1].bytes, LeastBytes))) {
      return true;
    }
  }
  return false;
}

std::string Growth::to_text() const {
  std::string text;
  for (std::size_t i = 0; i < costs.size(); ++i) {
    text += fmt::format("{}{}: {:.1f} ms, {} kB", i > 0 ? "; " : "", size << 2 * i, 1e3 * costs[i].seconds,
                        costs[i].bytes >> 10U);
  }
  return text;
}

Growth growth_of(const Prepare& prepare, std::size_t least, std::size_t largest) {
  std::size_t size = least;
  Measured first = prepare(size);
  while (size * 2 <= largest && (first(), cost_of(first).seconds) < LeastSeconds) {
    size *= 2;
    first = prepare(size);
  }
  const Growth growth = growth_from(first, prepare, size);
  if (!growth.is_too_fast() || largest < LeastUnlimited) return growth;
  return growth_from(prepare(size * 4), prepare, size * 4);
}

}  // namespace scaling
