// Resampled importance sampling chooses directions of the product of BRDF and incident light (Talbot, Cline
// and Egbert 2005, "Importance resampling for global illumination"; thesis section 5.5, algorithm 7). From M
// candidates that follow the BRDF it chooses N that follow the product with the incoming light, so that
// costly factors such as visibility are evaluated for only N directions.
//
// The thesis resamples by L. For candidates in proportion to f cos that equals f L cos / p, which is right
// for candidates of any scheme and is used here.
#pragma once

#include <cstddef>
#include <vector>

#include "renderer/reflectance/reflector.h"

namespace reflectance {

/// Numbers of candidates and chosen directions, both 1 or more.
struct Resampling {
  int candidates = 1;  ///< M
  int chosen = 1;      ///< N

  bool operator==(const Resampling&) const = default;
};

/// Chooses a few of many candidates in proportion to their weights.
class Resampler {
 public:
  void clear();  ///< Forgets all candidates.

  /// Adds a candidate with its single-sample estimate of the integral, f L cos / p without visibility.
  /// Candidates that contribute nothing count too.
  void add(const Vec3f& direction, const Rgb& estimate);

  /// Resamples `count` of the candidates, with replacement, in proportion to the RGB mean of their estimates,
  /// and calls use(direction, estimate) once for each that was chosen. The sum of these estimates, each times
  /// any function of its direction (visibility), is an unbiased estimate of the integral of the product.
  ///
  /// The choice is stratified by one number in [0,1) (systematic resampling): a candidate of probability s is
  /// chosen floor(count s) or ceil(count s) times.
  template <class Use>
  void choose(int count, float xi, const Use& use) const {
    if (!(total_ > 0)) return;
    const double step = total_ / count;
    const double average = total_ / static_cast<double>(candidates_.size());
    double sum = 0;
    int taken = 0;
    for (const Candidate& candidate : candidates_) {
      sum += candidate.weight;
      int copies = 0;
      for (; taken < count && (taken + double(xi)) * step < sum; ++taken) ++copies;
      if (copies == 0) continue;
      use(candidate.direction,
          candidate.estimate * static_cast<float>(average * copies / (candidate.weight * count)));
    }
  }

 private:
  struct Candidate {
    Vec3f direction;
    Rgb estimate;
    double weight = 0;
  };

  std::vector<Candidate> candidates_;
  double total_ = 0;  ///< sum of the weights, in order
};

/// Estimates reflected light by resampling. `draw(j)` returns candidate j as Reflector::sample does, delta
/// directions included; `radiance(v)` is the unoccluded light from a local direction; use(v, estimate)
/// receives the chosen ones, see Resampler::choose. Pass the same resampler again to reuse its memory.
template <class Draw, class Radiance, class Use>
void resample(Resampler& resampler, const Resampling& counts, float xi, const Draw& draw,
              const Radiance& radiance, const Use& use) {
  resampler.clear();
  for (int j = 0; j < counts.candidates; ++j) {
    const auto sample = draw(j);
    const Vec3f direction = sample ? sample->direction : Vec3f(0, 0, 1);
    resampler.add(direction, sample ? sample->weight * radiance(direction) : Rgb(0));
  }
  resampler.choose(counts.chosen, xi, use);
}

inline void Resampler::clear() {
  candidates_.clear();
  total_ = 0;
}

inline void Resampler::add(const Vec3f& direction, const Rgb& estimate) {
  candidates_.push_back({direction, estimate, static_cast<double>(mean(estimate))});
  total_ += candidates_.back().weight;
}

}  // namespace reflectance
