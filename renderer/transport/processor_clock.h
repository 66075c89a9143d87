#pragma once

#include <cstdint>

#include <x86intrin.h>

namespace transport {

/// Reads the processor's time stamp counter, whose ticks have the same length on all cores of the machines
/// that we build for, at a third of the cost of a clock. The tick length is measured: see
/// Render::sampling_seconds.
inline std::uint64_t processor_ticks() { return __rdtsc(); }

}  // namespace transport
