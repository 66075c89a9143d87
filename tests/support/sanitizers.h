#pragma once

namespace test {

/// True where sanitizers watch, which makes all slower: limits of time do not hold.
#ifdef GRANADA_HAS_SANITIZERS
inline constexpr bool HasSanitizers = true;
#else
inline constexpr bool HasSanitizers = false;
#endif

}  // namespace test
