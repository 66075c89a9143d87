#pragma once

#include <memory>
#include <optional>

#include "renderer/reflectance/model.h"

namespace reflectance {

struct CombinedBrdfs;

/// A weighted sum of other BRDFs, none of which is a sum itself. Without any it is black. One that is drawn
/// from is picked in proportion to its share of the albedo.
struct Combine {
  std::shared_ptr<const CombinedBrdfs> parts;

  static ModelTable<Combine> table() {
    ModelTable<Combine> table{"combine", "Weighted sum", "", {}};
    table.takes = grf::ModelInfo::Takes::Terms;
    table.not_conserving = "reflects the sum of its weights times each BRDF's albedo";
    return table;
  }

  template <class Real>
  Vec3<Real> evaluate(const Vec3<Real>& u, const Vec3<Real>& v) const;

  Rgb mirror(const Vec3f& u) const;
  float albedo_estimate(const Vec3f& u) const;
  std::optional<DirectionSample> sample(const Vec3f& u, const Uniforms& xi) const;
  float density(const Vec3f& u, const Vec3f& v) const;

  bool has_mirror() const;
  bool has_diffuse_part() const;
  bool has_glossy_part() const;
  bool is_anisotropic() const;
};

}  // namespace reflectance
