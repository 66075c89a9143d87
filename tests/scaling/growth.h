// Measurement of the growth of time and memory with the size of an input.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <string>

namespace scaling {

/// The time and memory of one run.
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

  /// Returns whether time or memory grew by over `MostGrowth` from one size to the next. n log n grows by at
  /// most 5 for the sizes here, n^1.5 by 8.
  bool is_too_fast() const;
  std::string to_text() const;
};

constexpr double MostGrowth = 6;

/// Measures growth from the smallest size at which a run takes long enough to be measured, or from `largest`.
/// Growth that looks too fast is measured again, since other programs only make runs longer, and then at four
/// times the size, since exceeding a cache costs time once.
Growth growth_of(const Prepare& prepare, std::size_t least, std::size_t largest);

}  // namespace scaling
