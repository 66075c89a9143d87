#pragma once

#include <cstddef>
#include <functional>
#include <stdexcept>

#include <pthread.h>

namespace test {

// Threads have a stack of 8 MB, as the main thread has. A quarter of that must be enough without sanitizers,
// whose stack frames are several times as large.
#if defined(GRANADA_HAS_SANITIZERS) || !defined(__OPTIMIZE__)
inline constexpr std::size_t SmallStack = 8U << 20U;
#else
inline constexpr std::size_t SmallStack = 2U << 20U;
#endif

/// Runs the action in a thread with a stack of SmallStack bytes; the program crashes on overflow. Throws if
/// the thread cannot be created.
inline void run_on_small_stack(std::function<void()> action) {
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setstacksize(&attributes, SmallStack);
  pthread_t thread = {};
  const auto run = [](void* argument) -> void* {
    (*static_cast<std::function<void()>*>(argument))();
    return nullptr;
  };
  const bool started = pthread_create(&thread, &attributes, run, &action) == 0;
  pthread_attr_destroy(&attributes);
  if (!started) throw std::runtime_error("no thread");
  pthread_join(thread, nullptr);
}

}  // namespace test
