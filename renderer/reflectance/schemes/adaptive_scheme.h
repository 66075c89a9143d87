#pragma once

#include <cmath>

#include "renderer/reflectance/schemes/rejection_sampler.h"

namespace reflectance {

/// The adaptive disc method of the thesis (chapter 5): for any BRDF, with no parameter set by hand.
/// `mode=reject` is as printed: rejection in the leaves of quadtrees.
struct AdaptiveScheme {
  float nqt = 90;
  float naniso_qt = 0;
  float nmax = 2;
  float resolution = 800;
  bool release = false;
  int mode = 0;

  static ModelTable<AdaptiveScheme> table() {
    using Self = AdaptiveScheme;
    return {"adaptive",
            "Adaptive disc",
            "Montes, Urena, Garcia and Lastra 2008",
            {number_parameter(&Self::nqt, "nQT", 1, 1000, "trees over the view's angle to the normal"),
             number_parameter(&Self::naniso_qt, "nAnisoQT", 0, 1000,
                              "trees over the view's azimuth; 0: 1 if the BRDF is isotropic, else 16"),
             number_parameter(&Self::nmax, "nmax", 1.001F, 100, "tries that a leaf may need in the mean",
                              grf::ParameterScale::Logarithmic),
             number_parameter(&Self::resolution, "res", 2, 8192, "cells of the disc's grid along an edge"),
             boolean_parameter(&Self::release, "release",
                               "free the tables: less memory, and a density that is not quite exact"),
             word_parameter(&Self::mode, "mode", {"reject"}, "how a point of a leaf is drawn")}};
  }

  static std::string refusal(const Brdf& brdf) { return RejectionSampler::refusal(brdf); }

  void build(const Brdf& brdf) {
    RejectionSettings settings;
    settings.thetas = static_cast<int>(std::lround(nqt));
    settings.phis = static_cast<int>(std::lround(naniso_qt));
    settings.most_tries = nmax;
    settings.resolution = static_cast<int>(std::lround(resolution));
    settings.keep_table = !release;
    rejection_.build(brdf, settings);
  }

  std::size_t bytes() const { return rejection_.bytes(); }

  std::optional<DirectionSample> sample(const Brdf& brdf, const Vec3f& u, const Uniforms& xi) const {
    return rejection_.sample(brdf, u, xi);
  }
  float density(const Brdf& brdf, const Vec3f& u, const Vec3f& v) const {
    return rejection_.density(brdf, u, v);
  }

  /// See reflectance::sample_many.
  void sample_many(const Brdf& brdf, const Vec3f& u, std::span<const Uniforms> xi,
                   std::vector<DirectionSample>& out) const {
    rejection_.sample_many(brdf, u, xi, out);
  }

  /// The trees of `mode=reject`; null before `build`.
  const RejectionTrees* trees() const { return rejection_.trees(); }

 private:
  RejectionSampler rejection_;
};

}  // namespace reflectance
