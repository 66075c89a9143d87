#include "renderer/reflectance/coverage.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "renderer/reflectance/halton.h"

namespace reflectance {
namespace {

/// A sampled direction: the light that it carries, and its weight under the scheme.
struct Carried {
  float light = 0;
  float weight = 0;
};

/// Samples with the BRDF's own sampler, whose pdf is above 0 everywhere.
std::optional<Carried> carried(const Scheme& scheme, const Brdf& brdf, const Vec3f& u, std::uint32_t index) {
  const auto drawn = OwnScheme().sample(brdf, u, halton_point(index));
  if (!drawn || !(mean(drawn->weight) > 0)) return std::nullopt;
  const float pdf = reflectance::pdf(scheme, brdf, u, drawn->direction);
  const float value = mean(evaluate(brdf, u, drawn->direction)) * drawn->direction.z;
  return Carried{mean(drawn->weight), pdf > 0 ? value / pdf : HUGE_VALF};
}

float missed_fraction(const Scheme& scheme, const Brdf& brdf, const Vec3f& u) {
  constexpr std::uint32_t Directions = 1024;
  constexpr double MostWeight = 100;  // in albedos
  std::array<Carried, Directions> all = {};
  double sum = 0;
  for (std::uint32_t i = 0; i < Directions; ++i) {
    all[i] = carried(scheme, brdf, u, i).value_or(Carried());
    sum += all[i].light;
  }
  double missed = 0;
  for (const Carried& one : all) {
    if (one.weight > MostWeight * sum / Directions) missed += one.light;
  }
  return sum > 0 ? static_cast<float>(missed / sum) : 0.0F;
}

}  // namespace

float missed_fraction(const Scheme& scheme, const Brdf& brdf) {
  constexpr std::array<float, 6> Degrees = {1, 20, 40, 60, 75, 85};
  constexpr std::array<float, 3> Azimuths = {0, 0.7F, 1.5F};
  if (!has_nonspecular_part(brdf)) return 0;
  float most = 0;
  for (const float degrees : Degrees) {
    const float theta = degrees * Pi / 180;
    for (const float phi : Azimuths) {
      most =
          std::max(most, missed_fraction(scheme, brdf, from_angles(std::cos(theta), std::sin(theta), phi)));
    }
  }
  return most;
}

}  // namespace reflectance
