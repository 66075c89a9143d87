#pragma once

#include <cstdlib>

namespace test {

/// True in a long run (granada_long_run, label full), in which tests try all cases, and not a choice of them.
inline bool tries_all() { return std::getenv("TRY_ALL") != nullptr; }

}  // namespace test
