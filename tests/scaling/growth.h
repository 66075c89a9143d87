// How time and memory grow with the size of an input.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <string>

namespace scaling {

/// A cost is the time and memory that one run takes.
struct Cost {
  double seconds = 0;     ///< of the processor, all threads together
  std::size_t bytes = 0;  ///< of the heap at the most, above what was in use before
};

/// A function prepares the measured work for a size; preparing it does not count.
using Measured = std::function<void()>;
using Prepare = std::function<Measured(std::size_t size)>;

/// Costs of a size, four times and sixteen times the size.
struct Growth {
  std::size_t size = 0;
  std::array<Cost, 3> costs;

  /// Whether time or memory grew by over `MostGrowth` from one to the next. n log n grows by at most 5 for
  /// sizes that matter, n^1.5 by 8.
  bool is_too_fast() const;
  std::string to_text() const;
};

constexpr double MostGrowth = 6;

/// Measures from the least size on at which a run takes long enough to be measured, or from `largest` on.
/// Growth that looks too fast is measured again, since other programs disturb, but none makes a run shorter;
/// and then at four times the size, since what no longer fits a cache takes longer once.
Growth growth_of(const Prepare& prepare, std::size_t least, std::size_t largest);

}  // namespace scaling
