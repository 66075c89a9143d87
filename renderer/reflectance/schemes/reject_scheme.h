#pragma once

#include <cmath>

#include "renderer/reflectance/schemes/rejection_sampler.h"

namespace reflectance {

/// Rejection sampling over the whole disc: trees with only a root. A narrow lobe needs many tries, and a
/// sample that reaches RejectionTree::Bound is empty: the pdf integrates to less than 1 by as much.
struct RejectScheme : RejectionSampler {
  float nqt = 90;
  float naniso_qt = 0;
  float resolution = 800;
  bool release = false;

  static ModelTable<RejectScheme> table() {
    using Self = RejectScheme;
    return {.keyword = "reject",
            .title = "Rejection over the disc",
            .paper = "Montes, Urena, Garcia and Lastra 2008",
            .parameters =
                {number_parameter(&Self::nqt, "nQT", 1, 1000, "tables over the view's angle to the normal"),
                 number_parameter(&Self::naniso_qt, "nAnisoQT", 0, 1000,
                                  "tables over the view's azimuth; 0: 1 if the BRDF is isotropic, else 16"),
                 number_parameter(&Self::resolution, "res", 2, 8192,
                                  "grid resolution over the disc, in cells per edge"),
                 boolean_parameter(&Self::release, "release", "free the tables; values are then recomputed")},
            .description =
                "Rejection sampling over the whole disc of projected directions, under a table of f. It is "
                "`adaptive` without subdivision: good for diffuse surfaces, and slow for any lobe."};
  }

  void build(const Brdf& brdf) {
    RejectionSettings settings;
    settings.thetas = static_cast<int>(std::lround(nqt));
    settings.phis = static_cast<int>(std::lround(naniso_qt));
    settings.most_tries = AnyTries;
    settings.resolution = static_cast<int>(std::lround(resolution));
    settings.keep_table = !release;
    RejectionSampler::build(brdf, settings);
  }
};

}  // namespace reflectance
