#pragma once

#include <memory>
#include <span>

#include "renderer/reflectance/schemes/rejection_trees.h"
#include "renderer/reflectance/schemes/weighted.h"

namespace reflectance {

/// Sampling from rejection trees, shared by the schemes that use them.
class RejectionSampler {
 public:
  static std::string unsupported_reason(const Brdf& brdf) {
    return has_nonspecular_part(brdf) || !has_specular_part(brdf)
               ? ""
               : "the BRDF is only a mirror (delta part): use 'specular' or 'auto'";
  }

  void build(const Brdf& brdf, const RejectionSettings& settings) {
    trees_ = std::make_shared<const RejectionTrees>(brdf, settings);
  }

  std::size_t bytes() const { return trees_ ? trees_->bytes() : 0; }

  std::optional<DirectionSample> sample(const Brdf& brdf, const Vec3f& u, const Uniforms& xi) const {
    const auto drawn = trees_ ? trees_->draw(brdf, u, xi) : std::nullopt;
    if (!drawn) return std::nullopt;
    return weighted(brdf, u, drawn->direction, drawn->pdf);
  }
  float pdf(const Brdf& brdf, const Vec3f& u, const Vec3f& v) const {
    return trees_ ? trees_->pdf(brdf, u, v) : 0;
  }

  /// Draws a batch of samples; see reflectance::sample_many.
  void sample_many(const Brdf& brdf, const Vec3f& u, std::span<const Uniforms> xi,
                   std::vector<DirectionSample>& out) const {
    if (!trees_) return;
    for (const SampledDirection& drawn : trees_->draw_many(brdf, u, xi)) {
      if (const auto sample = weighted(brdf, u, drawn.direction, drawn.pdf)) out.push_back(*sample);
    }
  }

  /// Returns the trees; null before `build`.
  const RejectionTrees* trees() const { return trees_.get(); }

 private:
  std::shared_ptr<const RejectionTrees> trees_;
};

}  // namespace reflectance
