#pragma once

#include <cmath>
#include <optional>

#include "renderer/reflectance/glsl_functions.h"
#include "renderer/reflectance/model.h"

namespace reflectance::glsl {

template <class real>
struct MinnaertFormula {
  using vec3 = Imath::Vec3<real>;
  static constexpr real PI = Pi<real>;
#include "renderer/reflectance/common.glsl"
#include "renderer/reflectance/minnaert.glsl"
};

}  // namespace reflectance::glsl

namespace reflectance {

/// Minnaert's law of the lunar surface: Lambert for k = 1, darker towards the limb for larger k. As
/// published, it is not clamped at grazing, where k < 1 is unbounded, and not normalised by (k + 1)/2.
struct Minnaert {
  float k = 1;
  Rgb kd = Rgb(0.5F);

  static ModelTable<Minnaert> table() {
    return {
        .keyword = "minnaert",
        .title = "Minnaert",
        .paper = "Minnaert 1941",
        .parameters = {number_parameter(&Minnaert::k, "k", 0, 1000, "limb darkening: 1 is Lambert"),
                       reflectance_parameter(&Minnaert::kd, "kd", "albedo for k = 1")},
        .not_conserving =
            "for k < 1 the albedo 2 kd/(k+1) cos(theta)^(k-1) exceeds 1, and is unbounded towards grazing",
        .description =
            "Minnaert's law of the Moon's surface, whose full disc is as bright at its limb as in the "
            "middle. k = 1 is Lambert, k = 0.5 a disc of uniform brightness, and above 1 the limb darkens. "
            "As published it is not normalised: for k < 1 it reflects more than kd at every angle, without "
            "bound towards grazing.",
        .formula = "f = kd/pi (cu cv)^(k-1)",
        .example = "minnaert k=0.8 kd=1",
    };
  }

  template <class Real>
  Vec3<Real> evaluate(const Vec3<Real>& u, const Vec3<Real>& v) const {
    return glsl::MinnaertFormula<Real>().minnaert(u, v, Real(k), Vec3<Real>(kd));
  }

  bool has_glossy_part() const { return false; }
  float albedo_estimate(const Vec3f& u) const { return u.z > 1e-12F ? mean(kd) * relative_albedo(u) : 0; }

  // The pdf is (k+1)/(2 pi) cos(theta_v)^k, which matches the formula.
  std::optional<DirectionSample> sample(const Vec3f& u, const Uniforms& xi) const {
    const Vec3f v = power_direction(k, xi.direction);
    if (!(u.z > 1e-12F && v.z > 1e-12F)) return std::nullopt;
    return DirectionSample{v, kd * relative_albedo(u), pdf(u, v)};
  }
  float pdf(const Vec3f& u, const Vec3f& v) const {
    if (!(u.z > 1e-12F && v.z > 1e-12F)) return 0;
    return (k + 1) / (2 * Pi) * std::exp(k * glsl::log(v.z));
  }

 private:
  float relative_albedo(const Vec3f& u) const { return 2 / (k + 1) * std::exp((k - 1) * glsl::log(u.z)); }
};

}  // namespace reflectance
