#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "renderer/reflectance/glsl_functions.h"
#include "renderer/reflectance/model.h"

namespace reflectance::glsl {

template <class real>
struct EonFormula {
  using vec3 = Imath::Vec3<real>;
  static constexpr real PI = Pi<real>;
#include "renderer/reflectance/common.glsl"
#include "renderer/reflectance/eon.glsl"
#include "renderer/reflectance/rough_diffuse.glsl"
};

}  // namespace reflectance::glsl

namespace reflectance {

/// A cosine lobe that a matrix transforms, without its part below the horizon (clipped LTC): it resembles the
/// lobe of Eon for a view, and is sampled in closed form (Portsmouth, Kutz and Hill 2025, section 4; the
/// matrix is that paper's fit). In its frame, x is the view's azimuth.
class ClippedCosineLobe {
 public:
  /// The lobe for the cosine of the view's angle and a roughness, both from 0 to 1.
  ClippedCosineLobe(float cosine, float rough)
      : xx_(1 + rough * (0.303392F + (-0.518982F + 0.111709F * cosine) * cosine +
                         (-0.276266F + 0.335918F * cosine) * rough)),
        xz_(rough * (-1.16407F + 1.15859F * cosine + (0.150815F - 0.150105F * cosine) * rough) /
            (cosine * cosine * cosine - 1.43545F)),
        yy_(1 + rough * (0.20013F + (-0.506373F + 0.261777F * cosine) * cosine)),
        zx_(std::min(0.0F, rough * (0.540852F + (-1.01625F + 0.475392F * cosine) * cosine) /
                               (-1.0743F + (0.0725628F + cosine) * cosine))) {}

  Vec3f sample(const Vec2f& xi) const {
    const Vec2f point = to_disc(xi);
    // The lobe's visible part is above half of the disc and, towards the view, half an ellipse.
    const float width = std::sqrt(std::max(0.0F, 1 - point.y * point.y));
    const float x = visible() * (width - point.x) - width;
    const float z = std::sqrt(std::max(0.0F, 1 - x * x - point.y * point.y));
    return Vec3f(xx_ * x + xz_ * z, yy_ * point.y, zx_ * x + z).normalized();
  }

  float pdf(const Vec3f& v) const {
    // The direction before the transformation, times the determinant.
    const Vec3f before(yy_ * (v.x - xz_ * v.z), minor() * v.y, yy_ * (xx_ * v.z - zx_ * v.x));
    const float length2 = before.length2();
    if (!(v.z > 0 && before.z > 0)) return 0;
    const float determinant = yy_ * minor();
    const float stretch = determinant / length2;
    return before.z * stretch * stretch / (Pi * visible());
  }

 private:
  float minor() const { return xx_ - xz_ * zx_; }
  /// The part of the disc that is above the horizon after the transformation.
  float visible() const { return (1 + 1 / std::sqrt(zx_ * zx_ + 1)) / 2; }

  float xx_, xz_, yy_, zx_;
};

/// Rough diffuse surfaces whose facets reflect light to each other until it leaves: white facets reflect
/// all of it at every angle. Single scattering is Fujii's form of Oren and Nayar's model.
struct Eon {
  float rough = 0.5F;
  Rgb kd = Rgb(0.5F);

  static ModelTable<Eon> table() {
    return {
        .keyword = "eon",
        .title = "Energy-preserving Oren-Nayar",
        .paper = "Portsmouth, Kutz and Hill 2025",
        .parameters = {number_parameter(&Eon::rough, "rough", 0, 1,
                                        "roughness: 0 is Lambert; not the s of oren, which is an angle"),
                       reflectance_parameter(&Eon::kd, "kd", "albedo of the facets")},
        .description =
            "Rough diffuse surfaces such as plaster, clay and cloth, as OpenPBR's base has them. Light that "
            "facets scatter to each other is kept, so that white is white at every roughness and angle, and "
            "colours become more saturated the rougher the surface is. rough is the roughness, from Lambert "
            "(0) to very rough (1), and kd the albedo of the facets. For the model of 1994 see oren.",
        .formula = R"(
f = kd/pi A (1 + rough s/t) + k/pi (1 - E(u)) (1 - E(v))/(1 - m)
s = u.v - cu cv;  t = (s > 0 ? max(cu, cv) : 1);  A = 1/(1 + (1/2 - 2/(3 pi)) rough)
E(u) = A (1 + rough/pi (sin(theta) (theta - sin(theta) cos(theta)) + 2/3 (tan(theta) (1 - sin(theta)^3) - sin(theta))))
m = A (1 + (2/3 - 28/(15 pi)) rough);  k = kd^2 m/(1 - kd (1 - m)))",
        .example = "eon rough=0.8 kd=0.9",
    };
  }

  template <class Real>
  Vec3<Real> evaluate(const Vec3<Real>& u, const Vec3<Real>& v) const {
    return glsl::EonFormula<Real>().eon(u, v, Real(rough), Vec3<Real>(kd));
  }

  bool has_glossy_part() const { return false; }

  float albedo_estimate(const Vec3f&) const { return mean(kd); }
  std::optional<DirectionSample> sample(const Vec3f& u, const Uniforms& xi) const {
    if (u.z <= 0) return std::nullopt;
    const bool is_uniform = xi.choice < uniform_part(u.z);
    const Vec3f v =
        is_uniform ? uniform_direction(xi.direction) : Azimuth(u).turn(lobe(u).sample(xi.direction));
    if (v.z <= 0) return std::nullopt;
    const float density = pdf(u, v);
    if (!(density > 0)) return std::nullopt;
    return DirectionSample{v, evaluate(u, v) * (v.z / density), density};
  }
  float pdf(const Vec3f& u, const Vec3f& v) const {
    if (u.z <= 0 || v.z <= 0) return 0;
    const float uniform = uniform_part(u.z);
    return uniform / (2 * Pi) + (1 - uniform) * lobe(u).pdf(Azimuth(u).turn_back(v));
  }

 private:
  /// A rotation about the normal that takes the x axis to the azimuth of a view.
  struct Azimuth {
    Vec2f x = Vec2f(1, 0);

    explicit Azimuth(const Vec3f& u) {
      const Vec2f along(u.x, u.y);
      if (along.length2() > 0) x = along.normalized();
    }
    Vec3f turn(const Vec3f& v) const { return {x.x * v.x - x.y * v.y, x.y * v.x + x.x * v.y, v.z}; }
    Vec3f turn_back(const Vec3f& v) const { return {x.x * v.x + x.y * v.y, x.x * v.y - x.y * v.x, v.z}; }
  };

  ClippedCosineLobe lobe(const Vec3f& u) const { return {u.z, rough}; }
  /// The probability of a uniform direction, for what the lobe leaves out (the paper's fit).
  float uniform_part(float cosine) const {
    return std::pow(rough, 0.1F) *
           (0.162925F + (-0.372058F + (0.538233F - 0.290822F * cosine) * cosine) * cosine);
  }
};

}  // namespace reflectance
