#pragma once

#include <cstdlib>

namespace test {

/// Returns true in a long run (granada_long_run, label full): tests try all cases instead of a subset.
inline bool tries_all() { return std::getenv("TRY_ALL") != nullptr; }

}  // namespace test
