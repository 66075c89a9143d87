#pragma once

#include <limits>

#include "renderer/reflectance/glsl_functions.h"
#include "renderer/reflectance/kirchhoff_lobe.h"
#include "renderer/reflectance/model.h"

namespace reflectance::glsl {

template <class real>
struct WestinFormula {
  using vec3 = Imath::Vec3<real>;
  static constexpr real PI = Pi<real>;
  static constexpr real EPSILON = std::numeric_limits<real>::epsilon();
#include "renderer/reflectance/common.glsl"
#include "renderer/reflectance/fresnel.glsl"
#include "renderer/reflectance/kirchhoff.glsl"
#include "renderer/reflectance/westin.glsl"
};

}  // namespace reflectance::glsl

namespace reflectance {

/// `he` without its effective roughness: cheaper, for surfaces with little self-shadowing. The thesis' print
/// is not reciprocal and counts shadowing twice; this has the geometry and masking-shadowing of `he`.
struct Westin : KirchhoffLobe<Westin> {
  static ModelTable<Westin> table() {
    return {
        .keyword = "westin",
        .title = "Westin-Arvo-Torrance",
        .paper = "Westin, Arvo and Torrance 1992",
        .parameters = kirchhoff_parameters<Westin>(),
        .not_continuous =
            "in float the series underflows at 1e-38: values below 1e-15, of surfaces smooth to 1e-5 of a "
            "wavelength, lose digits",
        .description =
            "`he` without the effective roughness (the roughness of what is neither masked nor shadowed): "
            "cheaper, for surfaces with little self-shadowing, such as varnish, lacquered wood and polished "
            "metal. Parameters and appearance are as there; the two differ only near grazing.",
        .formula = "As `he`, with s = sigma.",
        .example = "westin sigma=0.1 tau=3 nreal=0.617 nimag=2.63",
    };
  }

  template <class Real>
  Vec3<Real> evaluate(const Vec3<Real>& u, const Vec3<Real>& v) const {
    return glsl::WestinFormula<Real>().westin(u, v, Real(sigma), Real(tau), Vec3<Real>(lambda), Real(nreal),
                                              Real(nimag), Vec3<Real>(ks), Vec3<Real>(kd));
  }

  /// Returns the masking-shadowing factor for light along u.
  float shadowing(const Vec3f& u) const {
    return u.z * glsl::WestinFormula<float>().kirchhoff_shadowing_over_cosine(u, sigma, tau);
  }

  Rgb specular_weight(const Vec3f& u) const {
    return glsl::WestinFormula<float>().westin_specular(u, sigma, tau, lambda, nreal, nimag, ks);
  }
};

}  // namespace reflectance
