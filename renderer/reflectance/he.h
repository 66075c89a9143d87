#pragma once

#include <limits>

#include "renderer/reflectance/glsl_functions.h"
#include "renderer/reflectance/kirchhoff_lobe.h"
#include "renderer/reflectance/model.h"

namespace reflectance::glsl {

template <class real>
struct HeFormula {
  using vec3 = Imath::Vec3<real>;
  static constexpr real PI = Pi<real>;
  static constexpr real EPSILON = std::numeric_limits<real>::epsilon();
#include "renderer/reflectance/common.glsl"
#include "renderer/reflectance/fresnel.glsl"
#include "renderer/reflectance/he.glsl"
#include "renderer/reflectance/kirchhoff.glsl"
};

}  // namespace reflectance::glsl

namespace reflectance {

/// Physical optics of a Gaussian rough surface: ideal specular, directional-diffuse (diffraction) and
/// Lambertian parts. The paper's formulas for unpolarised light, of which the thesis has only an expansion.
/// For roughness large in wavelengths it tends to Beckmann facets of slope 2 sigma/tau, else to a mirror.
struct He : KirchhoffLobe<He> {
  static ModelTable<He> table() {
    return {
        .keyword = "he",
        .title = "He-Torrance-Sillion-Greenberg",
        .paper = "He, Torrance, Sillion and Greenberg 1991",
        .parameters = kirchhoff_parameters<He>(),
        .not_continuous =
            "in float the series underflows at 1e-38: values below 1e-15, of surfaces smooth to 1e-5 of a "
            "wavelength, lose digits",
        .description =
            "Metals, glass and plastics by wave optics, the most complete of the models here: ideal "
            "specular, directional-diffuse (diffraction) and Lambertian parts, whose weights follow from the "
            "rms height (sigma) and correlation length (tau) of the surface and from the wavelength. If the "
            "roughness is small against the wavelength it is a mirror, if large Beckmann microfacets of "
            "slope 2 sigma/tau; in between it changes from one to the other with angle and colour.",
        .formula = R"(
f = ks F(u.h) S(u) S(v)/(cu cv) 4 ((u.h)/cos(delta))^2 D/pi + kd/pi;  specular_weight(u) = ks F(cu) S(u)^2 exp(-g)
D = (pi tau/(2 lambda))^2 sum over m >= 1 of g^m e^-g/(m! m) exp(-b/m)
g = (2 pi s/lambda (cu + cv))^2;  b = (pi tau/lambda)^2 ((ux+vx)^2 + (uy+vy)^2)
s = sigma/sqrt(1 + W(2 ln K)), K = sum over u and v of tan(theta) erfc(tau/(2 sigma) cot(theta))/(2 sqrt(2 pi))
W(x) + ln W(x) = x;  S: shadowing by the surface itself)",
        .example = "he sigma=0.5 tau=3 lambda=800",
    };
  }

  template <class Real>
  Vec3<Real> evaluate(const Vec3<Real>& u, const Vec3<Real>& v) const {
    return glsl::HeFormula<Real>().he(u, v, Real(sigma), Real(tau), Vec3<Real>(lambda), Real(nreal),
                                      Real(nimag), Vec3<Real>(ks), Vec3<Real>(kd));
  }

  /// Returns the masking-shadowing factor for light along u.
  float shadowing(const Vec3f& u) const {
    return u.z * glsl::HeFormula<float>().kirchhoff_shadowing_over_cosine(u, sigma, tau);
  }

  Rgb specular_weight(const Vec3f& u) const {
    return glsl::HeFormula<float>().he_specular(u, sigma, tau, lambda, nreal, nimag, ks);
  }
};

}  // namespace reflectance
