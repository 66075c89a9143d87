// A library to be preloaded into a renderer that uses Embree (LD_PRELOAD): it measures the time that all
// threads spend in Embree's queries, and on exit writes `queries seconds cost` to the file that EMBREE_METER
// names. `cost` is the overhead of measuring a query, in seconds, which `seconds` does not include. A
// renderer's callbacks, which Embree calls, count as Embree.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include <x86intrin.h>

#include "tests/benchmarks/render/embree_queries.h"

namespace {

using embree_queries::next;
using embree_queries::Packet;
using embree_queries::PerThread;
using embree_queries::Single;

/// Counters of one thread, on cache lines of their own.
struct alignas(128) Counter {
  std::atomic<std::uint64_t> queries = 0;
  std::atomic<std::uint64_t> ticks = 0;

  /// Only one thread writes, so no atomic read-modify-write is needed.
  void add(std::uint64_t more_ticks) {
    queries.store(queries.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
    ticks.store(ticks.load(std::memory_order_relaxed) + more_ticks, std::memory_order_relaxed);
  }
};

template <class Query>
void measure(Counter& counter, const Query& query) {
  const std::uint64_t start = __rdtsc();
  query();
  counter.add(__rdtsc() - start);
}

class Meter {
 public:
  Meter() : start_(Clock::now()), start_ticks_(__rdtsc()) {}
  Meter(const Meter&) = delete;
  Meter& operator=(const Meter&) = delete;
  ~Meter() { write(); }

  Counter& new_counter() { return counters_.add(); }

 private:
  using Clock = std::chrono::steady_clock;

  void write() {
    const char* path = std::getenv("EMBREE_METER");
    std::FILE* file = path != nullptr ? std::fopen(path, "w") : nullptr;
    if (file == nullptr) return;
    const double ticks_per_second = static_cast<double>(__rdtsc() - start_ticks_) /
                                    std::chrono::duration<double>(Clock::now() - start_).count();
    constexpr int Empty = 1'000'000;
    Counter nothing;
    const std::uint64_t before = __rdtsc();
    for (int i = 0; i < Empty; ++i) measure(nothing, [] {});
    const double cost = static_cast<double>(__rdtsc() - before) / Empty;
    const double cost_inside = static_cast<double>(nothing.ticks) / Empty;
    double queries = 0;
    double ticks = 0;
    counters_.for_each([&](const Counter& counter) {
      queries += static_cast<double>(counter.queries);
      ticks += static_cast<double>(counter.ticks);
    });
    std::fprintf(file, "%.0f %.9g %.9g\n", queries, (ticks - queries * cost_inside) / ticks_per_second,
                 cost / ticks_per_second);
    std::fclose(file);
  }

  PerThread<Counter> counters_;
  Clock::time_point start_;
  std::uint64_t start_ticks_;
};

Counter& counter_of_thread() {
  static Meter meter;
  thread_local Counter& counter = meter.new_counter();
  return counter;
}

}  // namespace

// NOLINTBEGIN(readability-identifier-naming)
#define SINGLE(NAME)                                                   \
  extern "C" void NAME(void* scene, void* context, void* ray) {        \
    static Single* const query = next<Single>(#NAME);                  \
    measure(counter_of_thread(), [=] { query(scene, context, ray); }); \
  }
#define PACKET(NAME)                                                               \
  extern "C" void NAME(const int* valid, void* scene, void* context, void* rays) { \
    static Packet* const query = next<Packet>(#NAME);                              \
    measure(counter_of_thread(), [=] { query(valid, scene, context, rays); });     \
  }
SINGLE(rtcIntersect1)
SINGLE(rtcOccluded1)
PACKET(rtcIntersect4)
PACKET(rtcOccluded4)
PACKET(rtcIntersect8)
PACKET(rtcOccluded8)
PACKET(rtcIntersect16)
PACKET(rtcOccluded16)
// NOLINTEND(readability-identifier-naming)
