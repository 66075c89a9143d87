#pragma once

#include "renderer/reflectance/ashikhmin.h"
#include "renderer/reflectance/schemes/lobe_exponent.h"
#include "renderer/reflectance/schemes/weighted.h"

namespace reflectance {

/// Samples half vectors by the anisotropic power of Ashikhmin and Shirley. Directions below the horizon are
/// drawn and count as zero, so the pdf integrates to less than 1.
struct AnisotropicScheme {
  static constexpr bool IsIncomplete = true;

  float nu = OwnExponent;
  float nv = OwnExponent;

  static ModelTable<AnisotropicScheme> table() {
    constexpr auto Logarithmic = grf::ParameterScale::Logarithmic;
    return {.keyword = "anisotropic",
            .title = "Anisotropic half vectors",
            .paper = "Ashikhmin and Shirley 2000",
            .parameters = {number_parameter(&AnisotropicScheme::nu, "nu", OwnExponent, 1e6F,
                                            "exponent along x; below 0: the BRDF's own, or 40 if it has none",
                                            Logarithmic),
                           number_parameter(&AnisotropicScheme::nv, "nv", OwnExponent, 1e6F,
                                            "exponent along y; below 0: the BRDF's own, or 40 if it has none",
                                            Logarithmic)},
            .description =
                "Samples half vectors with one exponent along x and one along y, for brushed surfaces and "
                "fibres, and for any half-vector lobe."};
  }

  static std::string unsupported_reason(const Brdf&) { return {}; }

  void build(const Brdf& brdf) {
    exponents_ = own_exponents(brdf);
    if (nu >= 0) exponents_.x = nu;
    if (nv >= 0) exponents_.y = nv;
  }

  std::optional<DirectionSample> sample(const Brdf& brdf, const Vec3f& u, const Uniforms& xi) const {
    const Vec3f v = anisotropic_lobe_direction(u, exponents_, xi.direction);
    return weighted(brdf, u, v, pdf(brdf, u, v));
  }
  float pdf(const Brdf&, const Vec3f& u, const Vec3f& v) const {
    return u.z > 0 && v.z > 0 ? anisotropic_lobe_pdf(u, v, exponents_) : 0;
  }

 private:
  LobeExponents exponents_ = PlainExponents;
};

}  // namespace reflectance
