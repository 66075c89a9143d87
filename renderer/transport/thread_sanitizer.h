// ThreadSanitizer sees only what is compiled with it, and Debian's TBB is not: these say in its place that
// what one task did is known to those that TBB starts, or waits for, afterwards. Elsewhere they are nothing.
#pragma once

#if defined(__SANITIZE_THREAD__)
#define GRANADA_THREAD_SANITIZER 1
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define GRANADA_THREAD_SANITIZER 1
#endif
#endif

#ifdef GRANADA_THREAD_SANITIZER
extern "C" void __tsan_acquire(void* address);  // NOLINT: the sanitizer's name
extern "C" void __tsan_release(void* address);  // NOLINT: the sanitizer's name
#endif

namespace transport {

/// What was done before becomes visible to whoever calls `see` of the same object later.
inline void publish([[maybe_unused]] void* object) {
#ifdef GRANADA_THREAD_SANITIZER
  __tsan_release(object);
#endif
}

inline void see([[maybe_unused]] void* object) {
#ifdef GRANADA_THREAD_SANITIZER
  __tsan_acquire(object);
#endif
}

}  // namespace transport
