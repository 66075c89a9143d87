#pragma once

#include <cmath>

#include "renderer/reflectance/beckmann_lobe.h"
#include "renderer/reflectance/cosine_and_lobe.h"
#include "renderer/reflectance/glsl_functions.h"
#include "renderer/reflectance/model.h"
#include "renderer/reflectance/refraction.h"

namespace reflectance::glsl {

template <class real>
struct HanrahanFormula {
  using vec3 = Imath::Vec3<real>;
  static constexpr real PI = Pi<real>;
#include "renderer/reflectance/beckmann.glsl"
#include "renderer/reflectance/common.glsl"
#include "renderer/reflectance/fresnel.glsl"
#include "renderer/reflectance/hanrahan.glsl"
#include "renderer/reflectance/refraction.glsl"
};

}  // namespace reflectance::glsl

namespace reflectance {

/// Layered materials such as skin and leaves: a rough surface, single scattering in one layer, and the
/// multiple scattering as a Lambertian part. The thesis mentions it without a formula; this is the paper's
/// first order.
struct Hanrahan : CosineAndLobe<Hanrahan> {
  float nreal = 1.4F;
  float g = 0.25F;
  Rgb albedo = Rgb(0.8F);
  float depth = 10;
  float rough = 0.3F;
  Rgb ks = Rgb(1);
  Rgb kd = Rgb(0.2F);

  static ModelTable<Hanrahan> table() {
    using Self = Hanrahan;
    constexpr auto Logarithmic = grf::ParameterScale::Logarithmic;
    return {
        .keyword = "hanrahan",
        .title = "Hanrahan-Krueger",
        .paper = "Hanrahan and Krueger 1993",
        .parameters = {number_parameter(&Self::nreal, "nreal", 1, 100, "index of refraction of the layer"),
                       number_parameter(&Self::g, "g", -0.99F, 0.99F,
                                        "mean cosine of the phase function, positive is forward"),
                       reflectance_parameter(&Self::albedo, "albedo", "single-scattering albedo"),
                       number_parameter(&Self::depth, "depth", 0, 1e6F,
                                        "optical thickness; 10 is as good as infinite", Logarithmic),
                       number_parameter(&Self::rough, "rough", 1e-3F, 10, "Beckmann roughness of the surface",
                                        Logarithmic),
                       reflectance_parameter(&Self::ks, "ks", "weight of the surface reflection"),
                       reflectance_parameter(&Self::kd, "kd", "reflectance of multiple scattering")},
        .description =
            "Subsurface scattering in layered materials such as skin and leaves: a rough dielectric surface "
            "over a scattering layer. albedo is the single-scattering albedo, g the mean cosine of the phase "
            "function (above 0 is forward), depth the optical thickness, and kd the colour of multiple "
            "scattering; rough and nreal make the sheen. It is flatter than Lambert, and brighter towards "
            "grazing for g above 0.",
        .formula = R"(
f = ks F B + albedo T p (1 - exp(-depth (1/u'z + 1/v'z)))/(nreal^2 (u'z + v'z)) + kd T/pi
u', v': refracted into the layer;  F = Fresnel(u.h);  T = (1 - Fresnel(cu)) (1 - Fresnel(cv))
p = (1-g^2)/(4 pi (1 + g^2 + 2 g u'.v')^1.5)
B: the facets of `kajiya`, of roughness rough)",
        .example =
            "hanrahan nreal=1.4 g=0.25 albedo=(0.95, 0.85, 0.75) depth=10 rough=0.3 ks=1 kd=(0.4, 0.2, 0.12)",
    };
  }

  template <class Real>
  Vec3<Real> evaluate(const Vec3<Real>& u, const Vec3<Real>& v) const {
    return glsl::HanrahanFormula<Real>().hanrahan(u, v, Real(nreal), Real(g), Vec3<Real>(albedo), Real(depth),
                                                  Real(rough), Vec3<Real>(ks), Vec3<Real>(kd));
  }

  bool has_glossy_part() const { return !is_black(ks) || !is_black(albedo); }

  // Scattering is sampled by its phase function if that or a layer of index 1 shapes the lobe. Else it is
  // nearly Lambertian outside, and most directions inside would be totally reflected.
  float diffuse_albedo(const Vec3f& u) const {
    return mean(kd) * Formula().transmittance(u.z, nreal) + (1 - phase_probability()) * scattering_albedo(u);
  }
  float lobe_albedo_estimate(const Vec3f& u) const {
    return surface_albedo(u) + phase_probability() * scattering_albedo(u);
  }

  Vec3f lobe_direction(const Vec3f& u, const Uniforms& xi) const {
    return xi.choice < surface_probability(u) ? beckmann_direction(u, rough, rough, xi.direction)
                                              : scattered_direction(u, xi.direction);
  }
  float lobe_pdf(const Vec3f& u, const Vec3f& v) const {
    const float surface = surface_probability(u);
    return surface * beckmann_pdf(u, v, rough, rough) + (1 - surface) * scattered_pdf(u, v);
  }

 private:
  using Formula = glsl::HanrahanFormula<float>;

  Vec3f scattered_direction(const Vec3f& u, const Vec2f& xi) const {
    const float q = (1 - g) * (1 + g) / (1 - g + 2 * g * xi.x);
    const float cosine =
        std::abs(g) < 1e-3F ? 1 - 2 * xi.x : std::clamp((1 + g * g - q * q) / (2 * g), -1.0F, 1.0F);
    const float sine = std::sqrt((1 - cosine) * (1 + cosine));
    const Frame frame(-Formula().refracted(u, nreal));
    return refracted_out(frame.to_world(from_angles(cosine, sine, 2 * Pi * xi.y)), nreal);
  }
  float scattered_pdf(const Vec3f& u, const Vec3f& v) const {
    const Vec3f inside = Formula().refracted(v, nreal);
    return Formula().henyey_greenstein(Formula().refracted(u, nreal), inside, g) *
           inside_per_outside(v, inside, nreal);
  }

  float surface_albedo(const Vec3f& u) const { return mean(ks) * Formula().fresnel(u.z, nreal, 0); }
  float scattering_albedo(const Vec3f& u) const {
    return mean(albedo) * Formula().transmittance(u.z, nreal) * -std::expm1(-2 * depth) / (3 * nreal * nreal);
  }
  float phase_probability() const {
    const float n2 = nreal * nreal;
    return std::max(g * g, 1 / (n2 * n2 * n2 * n2));
  }
  float surface_probability(const Vec3f& u) const {
    const float surface = surface_albedo(u);
    const float total = lobe_albedo_estimate(u);
    return total > 0 ? surface / total : 1;
  }
};

}  // namespace reflectance
