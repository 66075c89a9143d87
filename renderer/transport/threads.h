#pragma once

#include <cstddef>

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>

namespace transport {

/// Runs a function whose parallel loops use that many threads; 0: as many as the machine has.
template <class Function>
void run_with_threads(int threads, const Function& function) {
  const int count = threads > 0 ? threads : tbb::info::default_concurrency();
  // Without this, TBB would start no more threads than there are cores, whatever was asked for.
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(count));
  tbb::task_arena arena(count);
  arena.execute(function);
}

}  // namespace transport
