#pragma once

#include <cstddef>

namespace grf {

/// Bytes of the heap in use, of the whole program.
std::size_t allocated_bytes();

/// The most there were in use since the last `restart_peak`.
std::size_t peak_bytes();
void restart_peak();

}  // namespace grf
