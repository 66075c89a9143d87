#include "renderer/studies/rejection/interval.h"

#include <algorithm>

#include "renderer/reflectance/schemes/split_mix.h"
#include "renderer/studies/rejection/random.h"

namespace studies {

double grid_maximum(const Density& density, int cells) {
  double maximum = 0;
  for (int i = 0; i < cells; ++i)
    maximum = std::max(maximum, density.pdf(density.low + (i + 0.5) / cells * density.width()));
  return maximum;
}

// The density is on one side of the bound in all cells but one or two, where the error is quadratic.
double mass_below(const Density& density, double bound) {
  constexpr int Cells = 4096;
  const double width = density.width() / Cells;
  double sum = 0;
  double before = density.cdf(density.low);
  for (int i = 0; i < Cells; ++i) {
    const double upto = density.cdf(i + 1 < Cells ? density.low + (i + 1) * width : density.high);
    sum += std::min(upto - before, bound * width);
    before = upto;
  }
  return sum;
}

IntervalTree::IntervalTree(const Density& density, double most_tries) {
  add(density, {density.low, density.high, density.maximum(), density.mass()}, most_tries, 0);
}

void IntervalTree::add(const Density& density, const Leaf& part, double most_tries, int depth) {
  constexpr int Deepest = 40;
  constexpr double LeastMass = 1e-9;  // a difference of two values of the cdf has not many digits below
  const double volume = (part.high - part.low) * part.bound;
  if (depth < Deepest && part.mass > LeastMass && volume > most_tries * part.mass) {
    const double middle = (part.low + part.high) / 2;
    for (const auto& [low, high] : {std::pair(part.low, middle), std::pair(middle, part.high)})
      add(density, {low, high, density.maximum(low, high), density.mass(low, high)}, most_tries, depth + 1);
    return;
  }
  leaves_.push_back(part);
  sums_.push_back((sums_.empty() ? 0 : sums_.back()) + std::max(part.mass, 0.0));
  // A part without mass is never chosen.
  volume_ += part.mass > 0 ? volume : 0;
}

const IntervalTree::Leaf& IntervalTree::leaf_of(double choice) const {
  const auto found = std::upper_bound(sums_.begin(), sums_.end(), choice * sums_.back());
  return leaves_[std::min(static_cast<std::size_t>(found - sums_.begin()), leaves_.size() - 1)];
}

const IntervalTree::Leaf& IntervalTree::leaf_at(double x) const {
  const auto found =
      std::partition_point(leaves_.begin(), leaves_.end(), [&](const Leaf& leaf) { return leaf.high < x; });
  return found == leaves_.end() ? leaves_.back() : *found;
}

Run<double> sample_interval(const Density& density, double bound, const RunLimits& limits,
                            std::uint32_t seed) {
  reflectance::SplitMix random = random_numbers(seed);
  const auto uniform = [&] { return random.next(); };
  return reject<double>(
      limits, [&](bool) { return density.low + uniform() * density.width(); }, [&] { return bound; },
      density.pdf, uniform);
}

Run<double> sample_interval(const Density& density, const IntervalTree& tree, const RunLimits& limits,
                            std::uint32_t seed) {
  reflectance::SplitMix random = random_numbers(seed);
  const auto uniform = [&] { return random.next(); };
  const IntervalTree::Leaf* leaf = nullptr;
  const auto propose = [&](bool was_accepted) {
    if (was_accepted) leaf = &tree.leaf_of(uniform());
    return leaf->low + uniform() * (leaf->high - leaf->low);
  };
  return reject<double>(
      limits, propose, [&] { return leaf->bound; }, density.pdf, uniform);
}

}  // namespace studies
