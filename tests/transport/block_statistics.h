#pragma once

#include <cstddef>
#include <vector>

#include "renderer/image/image.h"

namespace test {

/// Statistics of an image's block means over renders with different seeds: of the whole image, and of its 2 x
/// 2, 4 x 4 and 8 x 8 blocks, per channel. Small blocks show local errors, large ones errors that are small
/// everywhere.
class BlockStatistics {
 public:
  static constexpr int Tests = 3 * (1 + 4 + 16 + 64);

  void add(const image::Image& image);

  /// The p-value of the largest block difference if both have the same expected image: the least over all
  /// blocks, each tested by itself (Welch's t-test).
  friend double least_p_value(const BlockStatistics& a, const BlockStatistics& b);

 private:
  struct Block {
    double sum = 0;
    double squares = 0;  ///< of differences from the first mean, for accuracy
    double first = 0;
  };
  double mean(std::size_t block) const;
  double variance_of_mean(std::size_t block) const;

  int count_ = 0;
  std::vector<Block> blocks_ = std::vector<Block>(Tests);
};

double least_p_value(const BlockStatistics& a, const BlockStatistics& b);

}  // namespace test
