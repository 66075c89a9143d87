#pragma once

#include <cstddef>
#include <vector>

#include "renderer/transport/image/image.h"

namespace test {

/// The means of an image's blocks over renders of other seeds: of the whole image, and of its 2 x 2, 4 x 4
/// and 8 x 8 blocks, each channel for itself. Small blocks show what is wrong in one place, large ones what
/// is wrong by little everywhere.
class BlockStatistics {
 public:
  static constexpr int Tests = 3 * (1 + 4 + 16 + 64);

  void add(const transport::Image& image);

  /// The probability of differences as large as they are if both are of one image, the least of all blocks,
  /// each for itself (Welch's t-test).
  friend double least_p_value(const BlockStatistics& a, const BlockStatistics& b);

 private:
  struct Block {
    double sum = 0;
    double squares = 0;  ///< of differences from the first mean, so that digits are kept
    double first = 0;
  };
  double mean(std::size_t block) const;
  double variance_of_mean(std::size_t block) const;

  int count_ = 0;
  std::vector<Block> blocks_ = std::vector<Block>(Tests);
};

double least_p_value(const BlockStatistics& a, const BlockStatistics& b);

}  // namespace test
