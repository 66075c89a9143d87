#pragma once

namespace test {

/// True in builds with sanitizers, which are slower, so that time limits do not apply.
#ifdef GRANADA_HAS_SANITIZERS
inline constexpr bool HasSanitizers = true;
#else
inline constexpr bool HasSanitizers = false;
#endif

}  // namespace test
