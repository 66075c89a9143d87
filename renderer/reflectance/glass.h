#pragma once

#include <cmath>
#include <optional>

#include "renderer/reflectance/glsl_functions.h"
#include "renderer/reflectance/model.h"

namespace reflectance::glsl {

template <class real>
struct GlassFormula {
  using vec3 = Imath::Vec3<real>;
  static constexpr real PI = Pi<real>;
// GLSL requires names of unused parameters, and C++ warns of them.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"
#include "renderer/reflectance/common.glsl"
#include "renderer/reflectance/fresnel.glsl"
#include "renderer/reflectance/glass.glsl"
#pragma GCC diagnostic pop
};

}  // namespace reflectance::glsl

namespace reflectance {

/// A smooth dielectric: it reflects by Fresnel's equations, and refracts the rest. The BRDF is what it
/// reflects of light from outside; integrators take refraction from `split`, since it is no reflection.
struct Glass {
  float ior = 1.5F;
  Rgb colour = Rgb(1);
  float distance = 1;
  bool thin = false;

  static ModelTable<Glass> table() {
    return {
        .keyword = "glass",
        .title = "Glass",
        .paper = "Fresnel 1823",
        .parameters =
            {number_parameter(&Glass::ior, "ior", 1, 4, "index of refraction"),
             reflectance_parameter(&Glass::colour, "colour",
                                   "what is left of light after the distance in the glass, or after "
                                   "crossing a thin pane along its normal",
                                   {"color"}),
             number_parameter(&Glass::distance, "distance", 1e-6F, 1e6F,
                              "way in the glass that leaves this colour, in units of the scene; not "
                              "of a thin pane",
                              grf::ParameterScale::Logarithmic),
             boolean_parameter(&Glass::thin, "thin",
                               "a pane whose two sides are this one face, which does not bend light")},
        .description =
            "Glass, water, gems and window panes: a smooth surface that reflects by Fresnel's equations and "
            "lets "
            "the rest through, without roughness. A solid has faces all around, with their fronts outwards; "
            "light "
            "bends at them, and what it loses inside depends on its way there (Beer's law): a bottle is "
            "darker "
            "where it is thicker. A pane is one face with thin: light passes straight on, and lamps and the "
            "sky "
            "shine through it onto other surfaces without noise. Through a solid they shine as caustics, "
            "which "
            "only paths find that hit the lamp by chance: they need many samples, and large lamps. Solids "
            "must not "
            "overlap. In a combine or below a coat, glass is only a reflection.",
        .formula = R"(
f = 0
specular_weight(u) = F(cu);  of a pane F + F (1-F)^2 a^2/(1 - F^2 a^2)
transmitted: 1 - F(cu);  of a pane (1-F)^2 a/(1 - F^2 a^2)
a = colour^(1/ct);  ct = sqrt(ior^2 - 1 + cu^2)/ior)",
        .example = "glass ior=1.5 colour=(0.7, 0.9, 0.8) distance=0.1",
    };
  }

  template <class Real>
  Vec3<Real> evaluate(const Vec3<Real>& u, const Vec3<Real>& v) const {
    return glsl::GlassFormula<Real>().glass(u, v, Real(ior), Vec3<Real>(colour), Real(distance), thin);
  }

  Rgb specular_weight(const Vec3f& u) const {
    return u.z > 1e-12F ? formula().glass_specular(u, ior, colour, thin) : Rgb(0);
  }
  bool has_glossy_part() const { return false; }
  float albedo_estimate(const Vec3f&) const { return 0; }
  std::optional<DirectionSample> sample(const Vec3f&, const Uniforms&) const { return std::nullopt; }
  float pdf(const Vec3f&, const Vec3f&) const { return 0; }

  /// Fractions of the light at a surface that are reflected and let through.
  struct Split {
    Rgb reflected;
    Rgb transmitted;
    float refracted_cosine = 0;  ///< of the direction let through, to the normal on the other side
  };
  /// Returns the split at a cosine of incidence over 0, from outside or inside of a solid. Energies, not
  /// radiances: those grow by the squared ratio of the indices where light enters.
  Split split(float cosine, bool is_inside) const {
    if (thin) {
      return {formula().glass_pane_reflected(cosine, ior, colour),
              formula().glass_pane_transmitted(cosine, ior, colour), cosine};
    }
    const float index = is_inside ? 1 / ior : ior;
    const float squared = (index - 1) * (index + 1) + cosine * cosine;
    if (squared <= 0) return {Rgb(1), Rgb(0), 0};  // total reflection
    const float reflected = formula().glass_surface(cosine, index);
    return {Rgb(reflected), Rgb(1 - reflected), std::sqrt(squared) / index};
  }
  /// Returns what is left of light after a way in the glass.
  Rgb left_after(float way) const { return formula().glass_absorbed(colour, way, distance); }

 private:
  static glsl::GlassFormula<float> formula() { return {}; }
};

}  // namespace reflectance
