#pragma once

#include <cstdint>
#include <ctime>

#include <x86intrin.h>

namespace transport {

/// Reads the processor's time stamp counter, whose ticks have the same length on all cores of the machines
/// that we build for, at a third of the cost of a clock. The tick length is measured: see
/// Render::sampling_seconds.
inline std::uint64_t processor_ticks() { return __rdtsc(); }

/// Returns the processor time of all threads of this process, in seconds: unlike that of a clock on the wall,
/// it does not depend on what else the machine does.
inline double process_seconds() {
  timespec time = {};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace transport
