#include "tests/grf/allocation_meter.h"

#include <atomic>
#include <cstdlib>
#include <new>

#include <malloc.h>

namespace {

std::atomic<std::size_t> in_use = 0;
std::atomic<std::size_t> peak = 0;

}  // namespace

void* operator new(std::size_t size) {
  void* memory = std::malloc(size == 0 ? 1 : size);
  if (memory == nullptr) throw std::bad_alloc();
  const std::size_t now = in_use += malloc_usable_size(memory);
  std::size_t old_peak = peak;
  while (now > old_peak && !peak.compare_exchange_weak(old_peak, now)) {
  }
  return memory;
}

void operator delete(void* memory) noexcept {
  in_use -= malloc_usable_size(memory);
  std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept { operator delete(memory); }

namespace grf {

std::size_t allocated_bytes() { return in_use; }
std::size_t peak_bytes() { return peak; }
void restart_peak() { peak = in_use.load(); }

}  // namespace grf
