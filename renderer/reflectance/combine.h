#pragma once

#include <memory>
#include <optional>

#include "renderer/reflectance/model.h"

namespace reflectance {

struct CombinedBrdfs;

/// A weighted sum of other BRDFs, none of which is a sum itself, and some of which may be below layers. An
/// empty sum is black. Sampling picks a term with a probability proportional to its albedo.
struct Combine {
  std::shared_ptr<const CombinedBrdfs> parts;

  static ModelTable<Combine> table() {
    return {
        .keyword = "combine",
        .title = "Weighted sum",
        .not_isotropic = "isotropic if all of its BRDFs are",
        .not_reciprocal = "reciprocal if all of its BRDFs are",
        .not_conserving = "reflects the sum of its weights times each BRDF's albedo",
        .argument_kind = grf::ModelInfo::ArgumentKind::Terms,
        .description =
            "A sum of any number of BRDFs: the keyword is followed by weights of 0 or more and names of "
            "BRDFs defined before, `combine 0.3 clay, 0.7 varnish`. Nested sums are expanded. Sampling picks "
            "a term with a probability proportional to its weight times its albedo.",
    };
  }

  template <class Real>
  Vec3<Real> evaluate(const Vec3<Real>& u, const Vec3<Real>& v) const;

  Rgb specular_weight(const Vec3f& u) const;
  float albedo_estimate(const Vec3f& u) const;
  std::optional<DirectionSample> sample(const Vec3f& u, const Uniforms& xi) const;
  float pdf(const Vec3f& u, const Vec3f& v) const { return reflect(u, v).pdf; }
  /// Returns value and pdf at once, for less than both.
  Reflection reflect(const Vec3f& u, const Vec3f& v) const;

  bool has_specular_part() const;
  bool has_diffuse_part() const;
  bool has_glossy_part() const;
  bool is_anisotropic() const;
  std::optional<LobeExponents> lobe_exponents() const;
};

}  // namespace reflectance
