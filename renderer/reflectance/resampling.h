// Resampled importance sampling (Talbot, Cline and Egbert 2005, "Importance resampling for global
// illumination"; thesis section 5.5, algorithm 7): of M candidates that follow the BRDF, N are chosen that
// follow its product with the incoming light, so that what is costly, such as their visibility, is found for
// N directions alone.
//
// The thesis chooses by L; with candidates in proportion to f cos that is the same as by f L cos / p, which
// is right for candidates of any scheme and is what stands here.
#pragma once

#include <cstddef>
#include <vector>

#include "renderer/reflectance/reflector.h"

namespace reflectance {

/// How many directions are drawn, and how many of them are chosen; both 1 or more.
struct Resampling {
  int candidates = 1;  ///< M
  int chosen = 1;      ///< N

  bool operator==(const Resampling&) const = default;
};

class Resampler {
 public:
  void clear();

  /// A candidate and the estimate of the whole integral that it is by itself, f L cos / p without visibility.
  /// Those that carry nothing count too.
  void add(const Vec3f& direction, const Rgb& estimate);

  /// Chooses `count` of the candidates, with replacement, in proportion to the mean of their estimates over
  /// RGB, and calls use(direction, estimate) for each that was chosen, once. The sum of these estimates, each
  /// times anything that depends on its direction (visibility), is an unbiased one of the integral with it.
  ///
  /// The choice is stratified, with one number in [0,1) for all (systematic sampling): a candidate whose
  /// share is s is chosen floor(count s) or ceil(count s) times.
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
  double total_ = 0;  ///< of the weights, summed in order
};

/// Estimates reflected light. `draw(j)` gives candidate j, as Reflector::sample does, `radiance(v)` the light
/// that comes from a local direction if nothing is in its way, and use(v, estimate) gets what was chosen: see
/// Resampler::choose. Candidates may be those of the Dirac part. The resampler is there to be used again
/// without new memory.
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
