#pragma once

#include <cmath>

#include "renderer/reflectance/diffuse_and_lobe.h"
#include "renderer/reflectance/glsl_functions.h"
#include "renderer/reflectance/model.h"

namespace reflectance::glsl {

template <class real>
struct TorranceFormula {
  using vec3 = Imath::Vec3<real>;
  static constexpr real PI = Pi<real>;
#include "renderer/reflectance/common.glsl"
#include "renderer/reflectance/fresnel.glsl"
#include "renderer/reflectance/torrance.glsl"
};

}  // namespace reflectance::glsl

namespace reflectance {

/// Rough metals and dielectrics: microfacets of Beckmann's distribution in V-grooves, with Fresnel. The lobe
/// is D F G/(4 pi cu cv). The two prints of the thesis lack the 1/4 or cu: 4 cu cv is the Jacobian of
/// reflection at a facet, and without it the surface reflects up to four times the incident light.
struct Torrance : DiffuseAndLobe<Torrance> {
  float rough = 0.35F;
  float nreal = 1.5F;
  float nimag = 0;
  Rgb ks = Rgb(0.7F);
  Rgb kd = Rgb(0.3F);

  static ModelTable<Torrance> table() {
    using grf::ParameterScale;
    return {
        .keyword = "torrance",
        .title = "Cook-Torrance",
        .paper = "Torrance and Sparrow 1967, Cook and Torrance 1981",
        .parameters = {number_parameter(&Torrance::rough, "rough", 1e-4F, 10, "RMS slope of the facets",
                                        ParameterScale::Logarithmic, {"m"}),
                       number_parameter(&Torrance::nreal, "nreal", 1e-3F, 100,
                                        "real part of the index of refraction", ParameterScale::Logarithmic),
                       number_parameter(&Torrance::nimag, "nimag", 0, 100,
                                        "imaginary part of the index of refraction: 0 is a dielectric"),
                       reflectance_parameter(&Torrance::ks, "ks", "factor of the facets' reflection"),
                       reflectance_parameter(&Torrance::kd, "kd", "albedo of the diffuse part")},
        .description =
            "Metals, plastics and ceramics as specular microfacets in V-shaped grooves, with Fresnel. rough "
            "is the RMS slope: 0.05 is polished, 0.35 blasted. The index of refraction makes a dielectric "
            "(1.5 is glass and plastic) or a metal (gold 0.37 and 2.82, silver 0.177 and 3.638, copper 0.617 "
            "and 2.63, iron 2.485 and 3.433). The highlight strengthens towards grazing and its peak lies "
            "beyond the mirror direction (off-specular).",
        .formula = R"(
f = kd/pi + ks D F G/(4 pi cu cv)        F = Fresnel(u.h)
D = exp(-tan(delta)^2/rough^2)/(rough^2 cos(delta)^4)
G = min(1, 2 cos(delta) cu/(u.h), 2 cos(delta) cv/(u.h)))",
        .example = "torrance rough=0.35 nreal=0.617 nimag=2.63 ks=0.7 kd=0.3",
    };
  }

  template <class Real>
  Vec3<Real> evaluate(const Vec3<Real>& u, const Vec3<Real>& v) const {
    return glsl::TorranceFormula<Real>().torrance(u, v, Real(rough), Real(nreal), Real(nimag), Vec3<Real>(ks),
                                                  Vec3<Real>(kd));
  }

  // Samples visible normals (Heitz and d'Eon 2014, "Importance sampling microfacet-based BSDFs using the
  // distribution of visible normals"): of a groove's two sides, the one that faces u more is picked more
  // often.
  Vec3f lobe_direction(const Vec3f& u, const Uniforms& xi) const {
    const float slope = rough * std::sqrt(-std::log1p(-xi.direction.x));
    const float phi = 2 * Pi * xi.direction.y;
    const Vec3f one = Vec3f(slope * std::cos(phi), slope * std::sin(phi), 1).normalized();
    const Vec3f other(-one.x, -one.y, one.z);
    const float facing_one = std::max(0.0F, u.dot(one));
    const float facing_other = std::max(0.0F, u.dot(other));
    const bool takes_one = xi.choice * (facing_one + facing_other) < facing_one;
    return reflected(u, takes_one ? one : other);
  }
  float lobe_pdf(const Vec3f& u, const Vec3f& v) const {
    glsl::TorranceFormula<float> formula;
    const float c = formula.cosine_at_half(u, v);
    return formula.torrance_beckmann(u, v, rough) / (4 * Pi) *
           std::min(1 / u.z, (1 + v.z / u.z) * u.z / (c * c));
  }
  float lobe_ratio(const Vec3f& u, const Vec3f& v) const {
    glsl::TorranceFormula<float> formula;
    const float c = formula.cosine_at_half(u, v);
    // G over G1, where G1 is the masking by u only.
    const float hidden_from_u = (u.z + v.z) * u.z / (c * c);
    const float hidden_from_v = (u.z + v.z) * v.z / (c * c);
    return formula.fresnel_at_half(u, v, nreal, nimag) *
           std::min(1.0F, hidden_from_v / std::min(1.0F, hidden_from_u));
  }
  float lobe_albedo(const Vec3f& u) const {
    return glsl::TorranceFormula<float>().fresnel(u.z, nreal, nimag);
  }
};

}  // namespace reflectance
