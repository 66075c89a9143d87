// A density on an interval is sampled by rejection, under one bound and under the bounds of a subdivision.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/studies/rejection/density.h"
#include "renderer/studies/rejection/run.h"

namespace studies {

/// Returns the maximum over the centres of so many cells of the interval: an estimate from below, which the
/// thesis takes as bound.
double grid_maximum(const Density& density, int cells);

/// Returns the integral of the density over the interval, cut off above a bound: what rejection under that
/// bound samples, if it is too low.
double mass_below(const Density& density, double bound);

/// A dyadic subdivision of the interval, as the quadtree of section 5.1 of the thesis is one of the disc: a
/// part is halved while rejection in it would need more than `most_tries` tries on average. Bounds are exact.
class IntervalTree {
 public:
  struct Leaf {
    double low = 0;
    double high = 0;
    double bound = 0;
    double mass = 0;
  };

  /// The density has no pole; most_tries is above 1.
  IntervalTree(const Density& density, double most_tries);

  const std::vector<Leaf>& leaves() const { return leaves_; }
  /// Returns the expected fraction of tries that are accepted.
  double acceptance() const { return volume_ > 0 ? sums_.back() / volume_ : 0; }
  /// Returns the leaf that a number in [0,1) chooses, in proportion to its mass.
  const Leaf& leaf_of(double choice) const;
  const Leaf& leaf_at(double x) const;

 private:
  void add(const Density& density, const Leaf& part, double most_tries, int depth);

  std::vector<Leaf> leaves_;  ///< in the order of x
  std::vector<double> sums_;  ///< of the masses up to each leaf
  double volume_ = 0;         ///< sum of width times bound
};

/// Samples under one bound; the seed gives the random numbers.
Run<double> sample_interval(const Density& density, double bound, const RunLimits& limits,
                            std::uint32_t seed);
/// Samples a leaf in proportion to its mass, and by rejection in it.
Run<double> sample_interval(const Density& density, const IntervalTree& tree, const RunLimits& limits,
                            std::uint32_t seed);

}  // namespace studies
