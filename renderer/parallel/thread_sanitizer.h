// ThreadSanitizer sees only what is compiled with it, and Debian's TBB is not: these say in its place that
// what one task did is known to those that TBB starts, or waits for, afterwards. Elsewhere they are nothing.
#pragma once

#ifdef GRANADA_THREAD_SANITIZER
extern "C" void __tsan_acquire(void* address);  // NOLINT: the sanitizer's name
extern "C" void __tsan_release(void* address);  // NOLINT: the sanitizer's name
#endif

namespace parallel {

#ifdef GRANADA_THREAD_SANITIZER
namespace detail {
/// Stands for TBB. One for all: what a function captured, such as an object of its own, is what a task must
/// not read before it has called `see`.
inline constexpr char Tasks = 0;
inline void* tasks() { return const_cast<char*>(&Tasks); }
}  // namespace detail
#endif

/// What was done before becomes visible to whoever calls `see` later.
inline void publish() {
#ifdef GRANADA_THREAD_SANITIZER
  __tsan_release(detail::tasks());
#endif
}

inline void see() {
#ifdef GRANADA_THREAD_SANITIZER
  __tsan_acquire(detail::tasks());
#endif
}

}  // namespace parallel
