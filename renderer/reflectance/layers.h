#pragma once

#include "renderer/reflectance/brdf.h"

namespace reflectance {

/// A clear or tinted coat over any BRDF: the parameters of the `coat` model.
struct Coat {
  float ior = 1.5F;
  float alpha = 0.1F;
  Rgb tint = Rgb(1);

  static ModelTable<Coat> table();

  /// Returns the facets of the coat's surface.
  Ggx facets() const;

  /// Returns the part of light that the coat does not absorb on its way in or out, in a direction at this
  /// cosine outside of the coat: Beer's law along the refracted ray.
  Rgb clearness(float cosine) const;
};

/// A BRDF over another one: the `layer` model, which has no parameters.
struct Layer {
  static ModelTable<Layer> table();
};

/// Returns a BRDF above another one: f = top + t(u) t(v) base, where t is such that the base gets from each
/// direction what the top does not reflect: its albedo is that of the base, scaled by 1 - E(u), E the albedo
/// of the top. A symmetric scaling of the base as a matrix gives t (Sinkhorn and Knopp 1967; Knight, Ruiz and
/// Ucar 2014), so that two reciprocal BRDFs make a reciprocal one, whose albedo is at most 1 if theirs are.
/// Albedos come from quadrature by their samplers. Both may be sums.
Combine layered(const Brdf& base, const Brdf& top);

/// Returns a coat above a BRDF, which gets less light where the coat absorbs.
Combine layered(const Brdf& base, const Coat& coat);

}  // namespace reflectance
