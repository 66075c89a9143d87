#pragma once

#include <algorithm>
#include <cmath>

#include <ImathVec.h>

#include "renderer/reflectance/cosine_and_lobe.h"
#include "renderer/reflectance/glsl_functions.h"
#include "renderer/reflectance/half_power_lobe.h"
#include "renderer/reflectance/model.h"
#include "renderer/reflectance/refraction.h"

namespace reflectance::glsl {

template <class real>
struct GranierFormula {
  using vec2 = Imath::Vec2<real>;
  using vec3 = Imath::Vec3<real>;
  static constexpr real PI = Pi<real>;
#include "renderer/reflectance/common.glsl"
#include "renderer/reflectance/fresnel.glsl"
#include "renderer/reflectance/granier.glsl"
#include "renderer/reflectance/refraction.glsl"
};

}  // namespace reflectance::glsl

namespace reflectance {

/// Old metal, or dirt under an oily film: thin-film interference of two beams, from the film's surface and
/// its base. The base may be tilted against the surface, so that dispersion spreads its peak. The surface's
/// lobe is about h with Schlick's reflectance at u.h; the thesis' print, about n.v, is neither a reflection
/// nor reciprocal.
struct Granier : CosineAndLobe<Granier> {
  Rgb nreal = Rgb(1.50F, 1.51F, 1.52F);
  float d = 400;
  float n = 100;
  float m = 20;
  float tilt = 0;
  Rgb ks = Rgb(1);
  Rgb kt = Rgb(0.8F);
  Rgb kd = Rgb(0);

  static ModelTable<Granier> table() {
    using Self = Granier;
    constexpr auto Logarithmic = grf::ParameterScale::Logarithmic;
    return {
        .keyword = "granier",
        .title = "Granier-Heidrich",
        .paper = "Granier and Heidrich 2003",
        .parameters = {rgb_parameter(&Self::nreal, "nreal", 1, 100, "index of refraction of the film"),
                       in_unit("nm", number_parameter(&Self::d, "d", 0, 1e6F, "thickness of the film",
                                                      Logarithmic)),
                       number_parameter(&Self::n, "n", 0, 1e6F, "exponent of the outer lobe", Logarithmic),
                       number_parameter(&Self::m, "m", 0, 1e6F, "exponent of the inner lobe", Logarithmic),
                       in_unit("rad", number_parameter(&Self::tilt, "tilt", 0, Pi / 4,
                                                       "angle of the inner normal to the outer, towards x")),
                       reflectance_parameter(&Self::ks, "ks", "weight of the film's surface"),
                       reflectance_parameter(&Self::kt, "kt", "reflectance of the base"),
                       reflectance_parameter(&Self::kd, "kd", "albedo of the diffuse part")},
        .not_isotropic = "isotropic if tilt = 0",
        .not_conserving = "beams in phase reflect up to twice their sum, as published",
        .not_continuous =
            "in the dark middle of a fringe of two equal beams only rounding is left, some 1e-9 of the peak",
        .description =
            "Old metal, lacquer and dirt under a film of oil: thin-film interference of the beams from the "
            "film's surface and its base, so that colours change with the angle. d is the film's thickness, "
            "from the first colours (100 nm) to a pale rainbow (over 1000), n and m the exponents of the two "
            "lobes, kt the base's reflectance. tilt rotates the base against the surface, and an index that "
            "differs per channel then spreads its highlight (dispersion).",
        .formula = R"(
f = kd/pi + R + T + 2 cos(4 pi nreal d cos(delta)/lambda) sqrt(R T)        lambda = 645, 525, 445 nm
R = ks F(u.h) C(n) cos(delta)^n;  T = kt (1-F(cu)) (1-F(cv)) C(m) max(0, b.h')^m/nreal^2
h': half of u and v refracted;  b: the base's normal, turned by tilt;  F(c) = F0 + (1-F0) (1-c)^5, F0 = ((nreal-1)/(nreal+1))^2
C(n) = (n+2)(n+4)/(8 pi (2^(-n/2) + n)))",
        .example = "granier nreal=(1.5, 1.51, 1.52) d=250 n=100 m=20 tilt=0 ks=1 kt=0.9 kd=0",
    };
  }

  template <class Real>
  Vec3<Real> evaluate(const Vec3<Real>& u, const Vec3<Real>& v) const {
    return glsl::GranierFormula<Real>().granier(u, v, Vec3<Real>(nreal), Real(d), Real(n), Real(m),
                                                Real(tilt), Vec3<Real>(ks), Vec3<Real>(kt), Vec3<Real>(kd));
  }

  bool is_anisotropic() const { return tilt != 0; }
  bool has_glossy_part() const { return !is_black(ks) || !is_black(kt); }

  float diffuse_albedo(const Vec3f&) const { return mean(kd); }
  float lobe_albedo_estimate(const Vec3f& u) const { return outer_albedo(u) + inner_albedo(u); }

  // Samples the inner lobe inside, for one of the three indices of refraction.
  Vec3f lobe_direction(const Vec3f& u, const Uniforms& xi) const {
    const Vec3f h = power_direction(xi.choice < outer_probability(u) ? n : m, xi.direction);
    if (xi.choice < outer_probability(u)) return reflected(u, h);
    const int channel = std::min(2, static_cast<int>(3 * rescale(xi, outer_probability(u)).choice));
    const Vec3f inside = Formula().refracted(u, nreal[channel]);
    const Vec3f facet = Frame({std::sin(tilt), 0, std::cos(tilt)}).to_world(h);
    if (!(inside.dot(facet) > 0)) return Vec3f(0);
    return refracted_out(reflected(inside, facet), nreal[channel]);
  }
  float lobe_pdf(const Vec3f& u, const Vec3f& v) const {
    const float outer = outer_probability(u);
    return outer * half_power_pdf(u, v, n) + (1 - outer) * inner_pdf(u, v);
  }

 private:
  using Formula = glsl::GranierFormula<float>;

  float inner_pdf(const Vec3f& u, const Vec3f& v) const {
    if (nreal == Rgb(nreal.x)) return inner_pdf(u, v, nreal.x);
    return (inner_pdf(u, v, nreal.x) + inner_pdf(u, v, nreal.y) + inner_pdf(u, v, nreal.z)) / 3;
  }
  float inner_pdf(const Vec3f& u, const Vec3f& v, float index) const {
    const Vec3f a = Formula().refracted(u, index);
    const Vec3f b = Formula().refracted(v, index);
    return (m + 1) / (8 * Pi * cosine_of_half(a, b)) *
           Formula().tilted_power(Formula().half_inside(u, v, index), m, {std::sin(tilt), std::cos(tilt)}) *
           inside_per_outside(v, b, index);
  }

  // Schlick's reflectance at u, as if the facets were flat.
  float outer_reflectance(const Vec3f& u) const {
    const float index = mean(nreal);
    return 1 - 4 * index / ((index + 1) * (index + 1)) * Formula().one_minus_fifth_power(u.z);
  }
  float outer_albedo(const Vec3f& u) const { return mean(ks) * outer_reflectance(u); }
  float inner_albedo(const Vec3f& u) const { return mean(kt) * (1 - outer_reflectance(u)); }
  float outer_probability(const Vec3f& u) const {
    const float outer = outer_albedo(u);
    const float total = outer + inner_albedo(u);
    return total > 0 ? outer / total : 1;
  }
};

}  // namespace reflectance
