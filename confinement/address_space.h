// Whether the address space of a child process can be limited.
#pragma once

namespace confinement {

/// False under sanitizers, which reserve terabytes of address space, most of which is never touched.
#ifdef GRANADA_HAS_SANITIZERS
inline constexpr bool CanLimitAddressSpace = false;
#else
inline constexpr bool CanLimitAddressSpace = true;
#endif

}  // namespace confinement
