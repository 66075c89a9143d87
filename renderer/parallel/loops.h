// All loops of the renderer that use several threads. They run on TBB, and say to ThreadSanitizer what it
// cannot see of TBB: what was done before a loop is known in it, and what was done in it is known behind it.
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

/// Runs a function whose parallel loops use at most that many threads, of which the calling one is the first;
/// 0: as many as the machine has. Jobs that run at the same time do not limit each other.
template <class Function>
void run_with_threads(int threads, const Function& function) {
  // TBB starts no more threads than there are cores for all jobs of the process together, unless it is
  // allowed to. The least that it is allowed at one time holds for all of them, so every job says the same.
  constexpr std::size_t MoreThanAnyJobUses = 4096;
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, MoreThanAnyJobUses);
  tbb::task_arena arena(threads > 0 ? threads : tbb::info::default_concurrency());
  arena.execute(function);
}

/// Of the loops that are run here.
inline int thread_count() { return tbb::this_task_arena::max_concurrency(); }

/// Calls `body(i)` for each i from 0 to count - 1, in any order and on several threads.
template <class Index, class Body>
void for_each_index(Index count, const Body& body) {
  publish();
  tbb::parallel_for(Index{0}, count, [&body](Index i) {
    see();
    body(i);
    publish();
  });
  see();
}

/// Calls `body(begin, end)` for parts that together are 0 to count - 1: for bodies with something to set up.
template <class Body>
void for_each_part(std::size_t count, const Body& body) {
  publish();
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count),
                    [&body](const tbb::blocked_range<std::size_t>& part) {
                      see();
                      body(part.begin(), part.end());
                      publish();
                    });
  see();
}

/// Calls `work()` once for each thread that is there, each time on another one if none is busy elsewhere.
template <class Work>
void on_each_thread(const Work& work) {
  publish();
  tbb::parallel_for(
      tbb::blocked_range<int>(0, thread_count(), 1),
      [&work](const tbb::blocked_range<int>& workers) {
        see();
        for (int i = workers.begin(); i != workers.end(); ++i) work();
        publish();
      },
      tbb::simple_partitioner());
  see();
}

/// Runs two functions, each of them perhaps on another thread, of which neither needs the other.
template <class First, class Second>
void invoke(const First& first, const Second& second) {
  const auto task = [](const auto& function) {
    return [&function] {
      see();
      function();
      publish();
    };
  };
  publish();
  tbb::parallel_invoke(task(first), task(second));
  see();
}

}  // namespace parallel
