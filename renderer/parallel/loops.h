// oneTBB runs the renderer's multi-threaded loops. The loops tell ThreadSanitizer the happens-before
// relations that it cannot see in TBB: work before a loop happens before the loop's bodies, and these before
// what follows.
#pragma once

#include <cstddef>

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/task_arena.h>

#include "renderer/parallel/thread_sanitizer.h"

namespace parallel {

/// Returns how many threads a setting asks for: 0 is one per core.
inline int threads_for(int setting) { return setting > 0 ? setting : tbb::info::default_concurrency(); }

/// Runs a function with its parallel loops limited to `threads` threads, the calling one included; 0: one per
/// core. Concurrent calls do not limit each other.
template <class Function>
void run_with_threads(int threads, const Function& function) {
  // TBB caps the whole process at one thread per core unless allowed more, and the smallest limit that is
  // active anywhere in the process wins: so every call sets the same large one.
  constexpr std::size_t MoreThanAnyJobUses = 4096;
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, MoreThanAnyJobUses);
  tbb::task_arena arena(threads_for(threads));
  arena.execute(function);
}

/// Returns the number of threads that loops use here.
inline int thread_count() { return tbb::this_task_arena::max_concurrency(); }

/// Calls `body(i)` for each i from 0 to count - 1, in any order and on several threads.
template <class Index, class Body>
void for_each_index(Index count, const Body& body) {
  release();
  tbb::parallel_for(Index{0}, count, [&body](Index i) {
    acquire();
    body(i);
    release();
  });
  acquire();
}

/// Calls `body(begin, end)` for subranges that cover 0 to count - 1: for bodies with a set-up cost.
template <class Body>
void for_each_range(std::size_t count, const Body& body) {
  release();
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count),
                    [&body](const tbb::blocked_range<std::size_t>& part) {
                      acquire();
                      body(part.begin(), part.end());
                      release();
                    });
  acquire();
}

/// Calls `work()` once per available thread, each time on another thread if none is busy elsewhere.
template <class Work>
void on_each_thread(const Work& work) {
  release();
  tbb::parallel_for(
      tbb::blocked_range<int>(0, thread_count(), 1),
      [&work](const tbb::blocked_range<int>& workers) {
        acquire();
        for (int i = workers.begin(); i != workers.end(); ++i) work();
        release();
      },
      tbb::simple_partitioner());
  acquire();
}

/// Runs two independent functions, possibly on different threads.
template <class First, class Second>
void invoke(const First& first, const Second& second) {
  const auto task = [](const auto& function) {
    return [&function] {
      acquire();
      function();
      release();
    };
  };
  release();
  tbb::parallel_invoke(task(first), task(second));
  acquire();
}

}  // namespace parallel
