// ThreadSanitizer annotations describe TBB, which Debian builds without the sanitizer: they state that what
// one task did happens before the tasks that TBB starts, or waits for, afterwards. No-ops in other builds.
#pragma once

#ifdef GRANADA_THREAD_SANITIZER
extern "C" void __tsan_acquire(void* address);  // NOLINT: the sanitizer's name
extern "C" void __tsan_release(void* address);  // NOLINT: the sanitizer's name
#endif

namespace parallel {

#ifdef GRANADA_THREAD_SANITIZER
namespace detail {
/// The address that stands for TBB. One serves all: a task must not read anything that its function captured,
/// such as a synchronisation object, before it has called `acquire`.
inline constexpr char Tasks = 0;
inline void* tasks() { return const_cast<char*>(&Tasks); }
}  // namespace detail
#endif

/// Releases: what was done before becomes visible to any thread that calls `acquire` later.
inline void release() {
#ifdef GRANADA_THREAD_SANITIZER
  __tsan_release(detail::tasks());
#endif
}

inline void acquire() {
#ifdef GRANADA_THREAD_SANITIZER
  __tsan_acquire(detail::tasks());
#endif
}

}  // namespace parallel
