#pragma once

#include <cstddef>

namespace grf {

/// Returns the heap memory in use by the whole program, in bytes.
std::size_t allocated_bytes();

/// Returns the peak heap memory since the last `restart_peak`, in bytes.
std::size_t peak_bytes();
void restart_peak();

}  // namespace grf
