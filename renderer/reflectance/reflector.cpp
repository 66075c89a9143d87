#include "renderer/reflectance/reflector.h"

#include <algorithm>

#include "renderer/reflectance/coverage.h"

namespace reflectance {
namespace {

/// True if the scheme is the BRDF's own sampler, by name or by choice.
bool is_own(const Scheme& scheme) {
  const auto* chosen = std::get_if<AutoScheme>(&scheme);
  return chosen != nullptr ? !chosen->is_adaptive() : std::holds_alternative<OwnScheme>(scheme);
}

float share_by_cosine(const Scheme& scheme, const Brdf& brdf) {
  constexpr float LeastMissed = 1e-4F;
  constexpr float LeastShare = 0.1F;  // less would leave what is missed to a few samples of large weight
  constexpr float MostShare = 0.9F;
  const float missed = missed_share(scheme, brdf);
  return missed < LeastMissed ? 0 : std::clamp(missed, LeastShare, MostShare);
}

}  // namespace

Reflector::Reflector(const Brdf& brdf, const Scheme& scheme) : brdf_(brdf), scheme_(scheme) {
  build(scheme_, brdf_);
  if (may_miss(scheme_)) cosine_share_ = share_by_cosine(scheme_, brdf_);
  has_mirror_ = has_mirror(brdf_);
  has_density_ = reflectance::has_density(brdf_);
  samples_own_ = is_own(scheme_) && !(cosine_share_ > 0);
}

Reflection Reflector::reflect(const Vec3f& u, const Vec3f& v) const {
  if (!samples_own_) return {evaluate(u, v), density(u, v)};
  const Reflection reflection = std::visit(
      [&](const auto& model) {
        return Reflection{model.evaluate(u, v), model.density(u, v)};
      },
      brdf_);
  return {reflection.value, (1 - mirror_share(u)) * reflection.density};
}

std::optional<ScatterSample> Reflector::sample(const Vec3f& u, const Uniforms& xi) const {
  if (!has_mirror_ && samples_own_) {
    return std::visit(
        [&](const auto& model) -> std::optional<ScatterSample> {
          const auto drawn = model.sample(u, xi);
          if (!drawn) return std::nullopt;
          return ScatterSample{drawn->direction, drawn->weight, drawn->density, false};
        },
        brdf_);
  }
  const float share = mirror_share(u);
  if (xi.choice < share) return ScatterSample{mirrored(u), mirror(brdf_, u) / share, 0, true};
  const auto drawn = sample_density(u, rest_of(xi, share));
  if (!drawn) return std::nullopt;
  return ScatterSample{drawn->direction, drawn->weight / (1 - share), drawn->density * (1 - share), false};
}

std::optional<DirectionSample> Reflector::sample_density(const Vec3f& u, const Uniforms& xi) const {
  if (!(cosine_share_ > 0)) return reflectance::sample(scheme_, brdf_, u, xi);
  if (xi.choice < cosine_share_) {
    auto drawn = DiffuseScheme().sample(brdf_, u, xi);
    if (!drawn) return std::nullopt;
    const float density = mixed(drawn->direction, reflectance::density(scheme_, brdf_, u, drawn->direction));
    return DirectionSample{drawn->direction, drawn->weight * (drawn->density / density), density};
  }
  const auto drawn = reflectance::sample(scheme_, brdf_, u, rest_of(xi, cosine_share_));
  if (!drawn) return std::nullopt;
  const float density = mixed(drawn->direction, drawn->density);
  return DirectionSample{drawn->direction, drawn->weight * (drawn->density / density), density};
}

}  // namespace reflectance
