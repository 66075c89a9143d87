#pragma once

#include <cstddef>
#include <functional>
#include <stdexcept>

#include <pthread.h>

namespace test {

// Threads have 8 MB, as the main one has. Without sanitizers, whose frames are several times as large, a
// quarter of that has to do: nobody else is to be left without.
#if defined(GRANADA_HAS_SANITIZERS) || !defined(__OPTIMIZE__)
inline constexpr std::size_t SmallStack = 8U << 20U;
#else
inline constexpr std::size_t SmallStack = 2U << 20U;
#endif

/// Runs the action in a thread that has SmallStack; where that is not enough, the program crashes. Throws if
/// there can be no such thread.
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
