#include "renderer/reflectance/reflector.h"

#include <algorithm>

#include "renderer/reflectance/coverage.h"

namespace reflectance {
namespace {

/// Returns true if the scheme is the BRDF's own sampler, by name or by the choice of `auto`.
bool is_own(const Scheme& scheme) {
  const auto* chosen = std::get_if<AutoScheme>(&scheme);
  return chosen != nullptr ? !chosen->is_adaptive() : std::holds_alternative<OwnScheme>(scheme);
}

float share_by_cosine(float missed) {
  constexpr float LeastShare =
      0.1F;  // with less, the missed light would come from a few samples of large weight
  constexpr float MostShare = 0.9F;
  return std::clamp(missed, LeastShare, MostShare);
}

}  // namespace

Reflector::Reflector(const Brdf& brdf, const Scheme& scheme, MissedPart missed_part, Precision precision)
    : brdf_(brdf), scheme_(scheme), precision_(precision) {
  constexpr float LeastMissed = 1e-4F;
  build(scheme_, brdf_);
  const float missed = may_miss(scheme_) ? reflectance::missed_share(scheme_, brdf_) : 0;
  if (missed >= LeastMissed) {
    missed_share_ = missed;
    if (missed_part == MissedPart::DrawnByCosine) cosine_share_ = share_by_cosine(missed);
  }
  has_mirror_ = has_mirror(brdf_);
  has_density_ = reflectance::has_density(brdf_);
  samples_own_ = is_own(scheme_) && !(cosine_share_ > 0) && precision == Precision::Float;
}

float Reflector::share_of_mirror(const Vec3f& u) const {
  return std::visit(
      [&](const auto& model) {
        const float dirac = mean(mirror_of(model, u));
        return dirac > 0 ? dirac / (dirac + model.albedo_estimate(u)) : 0.0F;
      },
      brdf_);
}

Reflection Reflector::reflect(const Vec3f& u, const Vec3f& v) const {
  if (!samples_own_) return {evaluate(u, v), density(u, v)};
  const Reflection reflection = std::visit(
      [&](const auto& model) {
        if constexpr (requires { model.reflect(u, v); }) return model.reflect(u, v);
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
  auto drawn = sample_density(u, rest_of(xi, share));
  if (!drawn) return std::nullopt;
  if (precision_ == Precision::Double) {
    // Closed-form weights would bypass the formula.
    drawn->weight = evaluate_in_double(u, drawn->direction) * (drawn->direction.z / drawn->density);
  }
  return ScatterSample{drawn->direction, drawn->weight / (1 - share), drawn->density * (1 - share), false};
}

void Reflector::sample_many(const Vec3f& u, std::span<const Uniforms> xi,
                            std::vector<ScatterSample>& out) const {
  if (has_mirror_ || cosine_share_ > 0 || precision_ == Precision::Double) {
    for (const Uniforms& one : xi) {
      if (const auto drawn = sample(u, one)) out.push_back(*drawn);
    }
    return;
  }
  std::vector<DirectionSample> drawn;
  drawn.reserve(xi.size());
  reflectance::sample_many(scheme_, brdf_, u, xi, drawn);
  for (const DirectionSample& one : drawn) out.push_back({one.direction, one.weight, one.density, false});
}

Rgb Reflector::evaluate_in_double(const Vec3f& u, const Vec3f& v) const {
  return Rgb(std::visit(
      [&](const auto& model) {
        return model.evaluate(Imath::V3d(u).normalized(), Imath::V3d(v).normalized());
      },
      brdf_));
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
