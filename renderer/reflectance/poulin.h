#pragma once

#include <algorithm>
#include <cmath>

#include <ImathVec.h>

#include "renderer/reflectance/cosine_and_lobe.h"
#include "renderer/reflectance/glsl_functions.h"
#include "renderer/reflectance/half_power_lobe.h"
#include "renderer/reflectance/model.h"

namespace reflectance::glsl {

template <class real>
struct PoulinFormula {
  using vec2 = Imath::Vec2<real>;
  using vec3 = Imath::Vec3<real>;
  static constexpr real PI = Pi<real>;
#include "renderer/reflectance/common.glsl"
#include "renderer/reflectance/poulin.glsl"
};

}  // namespace reflectance::glsl

namespace reflectance {

/// Brushed metal, cloth and hair: parallel cylinders along x over a floor, with masking and shadowing. It
/// averages kd/pi and a Blinn lobe about each visible and lit normal, weighted by projected area. Reciprocal
/// and energy conserving, where the thesis prints intensities of unnormalised lobes. Light that meets a
/// second cylinder is lost.
struct Poulin : CosineAndLobe<Poulin> {
  float d = 2;
  float h = 0;
  float n = 50;
  Rgb ks = Rgb(0.5F);
  Rgb kd = Rgb(0.5F);

  static ModelTable<Poulin> table() {
    constexpr auto Logarithmic = grf::ParameterScale::Logarithmic;
    return {
        .keyword = "poulin",
        .title = "Poulin-Fournier",
        .paper = "Poulin and Fournier 1990",
        .parameters = {number_parameter(&Poulin::d, "d", 0, 1e6F,
                                        "distance of the cylinders' axes, in radii; 0 is a plane",
                                        Logarithmic),
                       number_parameter(&Poulin::h, "h", 0, 1, "height of the floor over the axes, in radii"),
                       number_parameter(&Poulin::n, "n", 0, 1e6F, "exponent of the lobe", Logarithmic),
                       reflectance_parameter(&Poulin::ks, "ks",
                                             "albedo of the lobe at normal incidence, for a plane"),
                       reflectance_parameter(&Poulin::kd, "kd", "albedo of the diffuse part of a plane")},
        .not_isotropic = "isotropic if d = 0 or h = 1, which is a plane",
        .not_continuous =
            "where the shadows of two cylinders just meet, the visible floor between them is a small "
            "difference, and vanishes",
        .description =
            "Brushed metal, satin and hair: parallel cylinders along x over a floor, with masking and "
            "shadowing. d is the distance of the cylinders (2 is side by side, more shows the floor, less "
            "makes them overlap) and h the height of the floor, 1 covering them. n, ks and kd are the "
            "Blinn-Phong material of cylinders and floor. Highlights run across the cylinders.",
        .formula = R"(
f = 1/(d cu cv) (the integral over the arc of g(a) [u.a]+ [v.a]+ + L cu cv g(z))
a: a normal of the cylinder, seen and lit;  L: the length of the floor that is seen and lit;  z: its normal
g(a) = kd/pi + ks C(n) max(0, a.h)^n with the half vector h;  C(n) = (n+2)(n+4)/(8 pi (2^(-n/2) + n)))",
        .example = "poulin d=2 h=0.01 n=100 ks=0.8 kd=0.2",
    };
  }

  template <class Real>
  Vec3<Real> evaluate(const Vec3<Real>& u, const Vec3<Real>& v) const {
    return glsl::PoulinFormula<Real>().poulin(u, v, Real(d), Real(h), Real(n), Vec3<Real>(ks),
                                              Vec3<Real>(kd));
  }

  bool is_anisotropic() const { return !Formula().is_plane(d, h); }

  float diffuse_albedo(const Vec3f&) const { return mean(kd); }
  float lobe_albedo_estimate(const Vec3f&) const { return mean(ks); }

  // Samples a half vector about the normal of a point visible from u, in proportion to projected area.
  Vec3f lobe_direction(const Vec3f& u, const Uniforms& xi) const {
    const Vec3f half = Frame(seen_normal(u, xi.choice)).to_world(power_direction(n, xi.direction));
    return u.dot(half) > 0 ? reflected(u, half) : Vec3f(0);
  }
  float lobe_pdf(const Vec3f& u, const Vec3f& v) const {
    if (!is_anisotropic()) return half_power_pdf(u, v, n);
    const Arc arc = arc_of(u);
    const float lobes = Formula().arc_lobe(u, v, arc.seen.low, arc.seen.high, n, true);
    return (n + 1) / (8 * Pi * cosine_of_half(u, v)) * lobes / arc.total() +
           arc.plane / arc.total() * half_power_pdf(u, v, n);
  }

 private:
  using Formula = glsl::PoulinFormula<float>;

  /// The arc visible from u, and the projected lengths of it and of the floor: u.m integrated.
  struct Arc {
    Formula::Seen seen;
    float psi, radius, sine_low, sine_high;  // psi is u's own angle in the cross-section
    float plane;

    float curved() const { return radius * (sine_high - sine_low); }
    float total() const { return curved() + plane; }
  };
  Arc arc_of(const Vec3f& u) const {
    Arc arc;
    arc.seen = Formula().seen_from(u, d, h);
    arc.psi = std::atan2(u.y, u.z);
    arc.radius = std::hypot(u.y, u.z);
    arc.sine_low = std::sin(arc.seen.low - arc.psi);
    arc.sine_high = std::sin(arc.seen.high - arc.psi);
    arc.plane = u.z * std::max(0.0F, Formula().floor_width(d, h) - arc.seen.hidden);
    return arc;
  }

  Vec3f seen_normal(const Vec3f& u, float choice) const {
    if (!is_anisotropic()) return {0, 0, 1};
    const Arc arc = arc_of(u);
    const float place = choice * arc.total();
    if (place >= arc.curved()) return {0, 0, 1};
    const float sine = arc.sine_low + place / arc.radius;
    const float a = arc.psi + std::asin(std::clamp(sine, -1.0F, 1.0F));
    return {0, std::sin(a), std::cos(a)};
  }
};

}  // namespace reflectance
