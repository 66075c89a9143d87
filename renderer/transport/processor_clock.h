#pragma once

#include <cstdint>

#include <x86intrin.h>

namespace transport {

/// The processor's time stamp: ticks of one length on all cores of the machines that we build for, at a third
/// of the cost of asking a clock. What a tick lasts is measured: see Render::sampling_seconds.
inline std::uint64_t processor_ticks() { return __rdtsc(); }

}  // namespace transport
