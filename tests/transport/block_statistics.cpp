#include "tests/transport/block_statistics.h"

#include <algorithm>
#include <cmath>

#include <boost/math/distributions/students_t.hpp>

namespace test {
namespace {

/// Returns the means of the blocks, level by level.
std::vector<double> means_of(const image::Image& image) {
  std::vector<double> means;
  for (int across = 1; across <= 8; across *= 2) {
    const int blocks = across * across;
    std::vector<double> sums(static_cast<std::size_t>(3) * static_cast<std::size_t>(blocks));
    std::vector<int> counts(static_cast<std::size_t>(blocks));
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x) {
        const int row = y * across / image.height;
        const int column = x * across / image.width;
        const auto block = static_cast<std::size_t>(row) * static_cast<std::size_t>(across) +
                           static_cast<std::size_t>(column);
        const auto& pixel = image.at(x, y);
        for (int k = 0; k < 3; ++k) sums[3 * block + static_cast<std::size_t>(k)] += pixel[k];
        ++counts[block];
      }
    }
    for (std::size_t i = 0; i < sums.size(); ++i) means.push_back(sums[i] / counts[i / 3]);
  }
  return means;
}

double p_value(double difference, double variance_a, double variance_b, int count_a, int count_b) {
  const double variance = variance_a + variance_b;
  // Values that are equal in all renders may still be rounded differently.
  if (difference < 1e-5) return 1;
  if (!(variance > 0)) return 0;
  const double freedom = variance * variance /
                         (variance_a * variance_a / (count_a - 1) + variance_b * variance_b / (count_b - 1));
  const boost::math::students_t distribution(freedom);
  return 2 * boost::math::cdf(boost::math::complement(distribution, difference / std::sqrt(variance)));
}

}  // namespace

void BlockStatistics::add(const image::Image& image) {
  const std::vector<double> means = means_of(image);
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    Block& block = blocks_[i];
    if (count_ == 0) block.first = means[i];
    block.sum += means[i] - block.first;
    block.squares += (means[i] - block.first) * (means[i] - block.first);
  }
  ++count_;
}

double BlockStatistics::mean(std::size_t block) const {
  return blocks_[block].first + blocks_[block].sum / count_;
}

double BlockStatistics::variance_of_mean(std::size_t block) const {
  const double sum = blocks_[block].sum;
  return std::max(0.0, blocks_[block].squares - sum * sum / count_) / (count_ - 1) / count_;
}

double least_p_value(const BlockStatistics& a, const BlockStatistics& b) {
  double least = 1;
  for (std::size_t i = 0; i < a.blocks_.size(); ++i) {
    const double difference = std::abs(a.mean(i) - b.mean(i));
    least = std::min(least,
                     p_value(difference, a.variance_of_mean(i), b.variance_of_mean(i), a.count_, b.count_));
  }
  return least;
}

}  // namespace test
