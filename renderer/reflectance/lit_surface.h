// A lit surface reflects light by one text for GLSL and C++: lit_surface.glsl. World frame: y is up.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "renderer/reflectance/brdf.h"
#include "renderer/reflectance/glsl_functions.h"

namespace reflectance {

/// Specular weights by view angle from 0 to 90 degrees, on which alone they depend.
using SpecularTable = std::array<Rgb, 64>;
SpecularTable specular_table(const Brdf& brdf);

/// A light at infinity.
struct DistantLight {
  Vec3f direction = Vec3f(0, 0, 1);  ///< unit, towards the light
  Rgb irradiance = Rgb(0);           ///< on a surface that faces it: pi shows a white diffuse one as 1
};

/// The GLSL of lit_surface.glsl with a BRDF's text before it (see `Shader`), of which it has the specular
/// part as a table: `uniform vec3 specular_weights[64]`. The lights are `uniform int light_count`, up to 3,
/// `uniform vec3 light_directions[3]` and `uniform vec3 light_irradiances[3]`. `environment` is GLSL of what
/// lit_surface.glsl needs of it, for which it can use `studio_radiance` below.
std::string lit_surface_shader(const std::string& brdf, const std::string& environment);

/// A studio's radiance from a direction: dim, brighter from above, with a soft window. studio.glsl.
Rgb studio_radiance(const Vec3f& direction);

/// A point of a surface in C++. `Environment` is called for the radiance from a direction in world space, and
/// has `is_drawn`, whether it draws directions; `pdf`, their solid-angle pdf; and `direction`, that of an
/// index of 0 or more. References must outlive this.
template <class Environment>
class LitSurface {
  using real = float;
  using vec3 = Vec3f;
  static constexpr float PI = glsl::Pi<float>;

 public:
  LitSurface(const Brdf& brdf, const SpecularTable& specular, const Environment& environment,
             std::span<const DistantLight> lights = {})
      : brdf_(brdf),
        specular_(specular),
        environment_(environment),
        lights_(lights),
        light_count(static_cast<int>(lights.size())) {}

  /// Sets the unit normal, and shifts the sampled directions of its environment by numbers in [0,1).
  void place(const Vec3f& at_normal, float first_shift, float second_shift) {
    normal = at_normal;
    tangent = tangent_at(normal);
    bitangent = bitangent_at(normal);
    shift_a = first_shift;
    shift_b = second_shift;
  }

  /// The radiance due to the specular reflection of the environment, for an eye in the local frame: see
  /// `eye_from`. (The functions of the text are not const.)
  Rgb specular(const Vec3f& u) { return specular_radiance(u); }
  /// The radiance due to the lights, and the mean of `count` estimates of that due to the environment, each
  /// from another direction. Multiples of 4 directions sample all lobes equally.
  Rgb reflected(const Vec3f& u, int first, int count) { return reflected_radiance(u, first, count, 1); }
  /// A direction in the local frame.
  Vec3f in_frame(const Vec3f& direction) { return to_local(direction); }
  /// The direction towards the eye in the local frame, clamped to the horizon.
  Vec3f eye_from(const Vec3f& to_eye) { return local_eye(to_eye); }

 private:
  vec3 brdf_value(const vec3& u, const vec3& v) const { return evaluate(brdf_, u, v); }
  vec3 brdf_specular(const vec3& u) const {
    const float place =
        std::acos(std::clamp(u.z, 0.0F, 1.0F)) / (PI / 2) * static_cast<float>(specular_.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), specular_.size() - 2);
    const float fraction = place - static_cast<float>(below);
    return specular_[below] * (1 - fraction) + specular_[below + 1] * fraction;
  }
  vec3 light_direction(int i) const { return lights_[static_cast<std::size_t>(i)].direction; }
  vec3 light_irradiance(int i) const { return lights_[static_cast<std::size_t>(i)].irradiance; }
  vec3 environment_radiance(const vec3& d) const { return environment_(d); }
  bool environment_is_drawn() const { return environment_.is_drawn(); }
  real environment_pdf(const vec3& d) const { return environment_.pdf(d); }
  vec3 environment_direction(int i) const { return environment_.direction(i); }

  static real exp(real x) { return std::exp(x); }
  static real log(real x) { return glsl::log(x); }
  static real sqrt(real x) { return std::sqrt(x); }
  static real floor(real x) { return std::floor(x); }
  static real sin(real x) { return glsl::sin(x); }
  static real cos(real x) { return glsl::cos(x); }
  static real max(real a, real b) { return std::max(a, b); }

#include "renderer/reflectance/lit_surface.glsl"

  const Brdf& brdf_;
  const SpecularTable& specular_;
  const Environment& environment_;
  std::span<const DistantLight> lights_;
  // NOLINTBEGIN(readability-identifier-naming): the names of the text
  vec3 tangent, bitangent, normal;
  real shift_a = 0.5F, shift_b = 0.5F;
  int light_count = 0;
  // NOLINTEND(readability-identifier-naming)
};

}  // namespace reflectance
