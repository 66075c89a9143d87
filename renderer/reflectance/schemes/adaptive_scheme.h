#pragma once

#include <cmath>
#include <memory>

#include "renderer/reflectance/schemes/rejection_sampler.h"
#include "renderer/reflectance/schemes/warp_trees.h"

namespace reflectance {

/// The adaptive sampling of the thesis (chapter 5): quadtrees that follow any BRDF, with no parameters to
/// set. `mode=reject` is as printed, with rejection sampling in the leaves; `mode=warp` inverts the trees
/// instead.
struct AdaptiveScheme {
  enum Mode { Warp, Reject };

  /// The pdf is hardly above 0 at the flanks of a lobe that is much narrower than the smallest leaf.
  static constexpr bool IsIncomplete = true;

  float nqt = 90;
  float naniso_qt = 0;
  float nmax = 2;
  float resolution = 800;
  bool release = false;
  int mode = Warp;

  static ModelTable<AdaptiveScheme> table() {
    using Self = AdaptiveScheme;
    return {
        .keyword = "adaptive",
        .title = "Adaptive quadtrees",
        .paper = "Montes, Urena, Garcia and Lastra 2008",
        .parameters = {number_parameter(&Self::nqt, "nQT", 1, 1000,
                                        "trees over the view's angle to the normal"),
                       number_parameter(
                           &Self::naniso_qt, "nAnisoQT", 0, 1000,
                           "trees over the view's azimuth; 0: as many as the BRDF needs, up to 16"),
                       number_parameter(&Self::nmax, "nmax", 1.001F, 100,
                                        "mode=reject: mean number of tries that a leaf may need",
                                        grf::ParameterScale::Logarithmic),
                       number_parameter(&Self::resolution, "res", 2, 8192,
                                        "mode=reject: grid resolution over the disc, in cells per edge"),
                       boolean_parameter(&Self::release, "release",
                                         "mode=reject: free the tables; values are then recomputed"),
                       word_parameter(&Self::mode, "mode", {"warp", "reject"},
                                      "how trees are sampled: by inversion (warp) or rejection")},
        .description =
            "Adaptive importance sampling of any BRDF, analytic, measured or combined, with no parameters to "
            "set. Quadtrees over the directions, for a set of views, follow f cos, and a sample descends "
            "from the root. With mode=warp, a pair of random numbers is warped to a direction by inverting "
            "the cdf, continuously except at tree splits, so that stratified or low-discrepancy points stay "
            "well distributed; leaves are bilinear, and trees of neighbouring views are blended. With "
            "mode=reject, the thesis' own method, rejection sampling under an upper bound of each leaf draws "
            "the point, and the nearest view's tree is used.",
    };
  }

  static std::string unsupported_reason(const Brdf& brdf) {
    return RejectionSampler::unsupported_reason(brdf);
  }

  void build(const Brdf& brdf) {
    if (mode == Reject) {
      RejectionSettings settings;
      settings.thetas = rounded(nqt);
      settings.phis = rounded(naniso_qt);
      settings.most_tries = nmax;
      settings.resolution = rounded(resolution);
      settings.keep_table = !release;
      rejection_.build(brdf, settings);
    } else {
      WarpTreesSettings settings;
      settings.theta_count = rounded(nqt);
      settings.phi_count = rounded(naniso_qt);
      warp_ = std::make_shared<const WarpTrees>(brdf, settings);
    }
  }

  std::size_t bytes() const { return warp_ ? warp_->bytes() : rejection_.bytes(); }

  std::optional<DirectionSample> sample(const Brdf& brdf, const Vec3f& u, const Uniforms& xi) const {
    if (!warp_) return rejection_.sample(brdf, u, xi);
    const auto drawn = warp_->sample(u, xi.direction);
    return drawn ? weighted(brdf, u, drawn->direction, drawn->pdf) : std::nullopt;
  }
  float pdf(const Brdf& brdf, const Vec3f& u, const Vec3f& v) const {
    return warp_ ? warp_->pdf(u, v) : rejection_.pdf(brdf, u, v);
  }

  /// Draws a batch of samples; see reflectance::sample_many.
  void sample_many(const Brdf& brdf, const Vec3f& u, std::span<const Uniforms> xi,
                   std::vector<DirectionSample>& out) const {
    if (!warp_) return rejection_.sample_many(brdf, u, xi, out);
    for (const Uniforms& one : xi) {
      if (const auto drawn = sample(brdf, u, one)) out.push_back(*drawn);
    }
  }

  /// Returns the trees of `mode=reject`; null before `build`.
  const RejectionTrees* trees() const { return rejection_.trees(); }

 private:
  static int rounded(float number) { return static_cast<int>(std::lround(number)); }

  RejectionSampler rejection_;
  std::shared_ptr<const WarpTrees> warp_;
};

}  // namespace reflectance
