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

/// With a lower fraction, the missed light would come from a few samples of large weight.
constexpr float LeastFraction = 0.1F;

float cosine_fraction_for(float missed) {
  constexpr float MostFraction = 0.9F;
  return std::clamp(missed, LeastFraction, MostFraction);
}

}  // namespace

Reflector::Reflector(const Brdf& brdf, const Scheme& scheme, MissedPart missed_part, Precision precision)
    : brdf_(brdf), scheme_(scheme), precision_(precision) {
  constexpr float LeastMissed = 1e-4F;
  build(scheme_, brdf_);
  const float missed = is_incomplete(scheme_) ? reflectance::missed_fraction(scheme_, brdf_) : 0;
  if (missed >= LeastMissed) {
    missed_fraction_ = missed;
    if (missed_part == MissedPart::DrawnByCosine) cosine_fraction_ = cosine_fraction_for(missed);
  }
  mixes_cosine_ = is_incomplete(scheme_) && missed_part == MissedPart::DrawnByCosine;
  find_facts();
}

// What the scheme misses of the other BRDF is not measured.
Reflector Reflector::with(const Brdf& brdf) const {
  Reflector other(*this);
  other.brdf_ = brdf;
  if (mixes_cosine_) other.cosine_fraction_ = std::max(cosine_fraction_, LeastFraction);
  other.find_facts();
  return other;
}

void Reflector::find_facts() {
  has_specular_part_ = has_specular_part(brdf_);
  has_nonspecular_part_ = reflectance::has_nonspecular_part(brdf_);
  samples_own_ = is_own(scheme_) && !(cosine_fraction_ > 0) && precision_ == Precision::Float;
}

float Reflector::compute_specular_probability(const Vec3f& u) const {
  return std::visit(
      [&](const auto& model) {
        const float dirac = mean(specular_weight_of(model, u));
        return dirac > 0 ? dirac / (dirac + model.albedo_estimate(u)) : 0.0F;
      },
      brdf_);
}

Reflection Reflector::reflect(const Vec3f& u, const Vec3f& v) const {
  if (!samples_own_) return {evaluate(u, v), pdf(u, v)};
  const Reflection reflection = std::visit(
      [&](const auto& model) {
        if constexpr (requires { model.reflect(u, v); }) return model.reflect(u, v);
        return Reflection{model.evaluate(u, v), model.pdf(u, v)};
      },
      brdf_);
  return {reflection.value, (1 - specular_probability(u)) * reflection.pdf};
}

std::optional<ScatterSample> Reflector::sample(const Vec3f& u, const Uniforms& xi) const {
  if (!has_specular_part_ && samples_own_) {
    return std::visit(
        [&](const auto& model) -> std::optional<ScatterSample> {
          const auto drawn = model.sample(u, xi);
          if (!drawn) return std::nullopt;
          return ScatterSample{drawn->direction, drawn->weight, drawn->pdf, false};
        },
        brdf_);
  }
  const float fraction = specular_probability(u);
  if (xi.choice < fraction) return ScatterSample{mirrored(u), specular_weight(brdf_, u) / fraction, 0, true};
  auto drawn = sample_nonspecular(u, rescale(xi, fraction));
  if (!drawn) return std::nullopt;
  if (precision_ == Precision::Double) {
    // Closed-form weights would bypass the formula.
    drawn->weight = evaluate_in_double(u, drawn->direction) * (drawn->direction.z / drawn->pdf);
  }
  return ScatterSample{drawn->direction, drawn->weight / (1 - fraction), drawn->pdf * (1 - fraction), false};
}

void Reflector::sample_many(const Vec3f& u, std::span<const Uniforms> xi,
                            std::vector<ScatterSample>& out) const {
  if (has_specular_part_ || cosine_fraction_ > 0 || precision_ == Precision::Double) {
    for (const Uniforms& one : xi) {
      if (const auto drawn = sample(u, one)) out.push_back(*drawn);
    }
    return;
  }
  std::vector<DirectionSample> drawn;
  drawn.reserve(xi.size());
  reflectance::sample_many(scheme_, brdf_, u, xi, drawn);
  for (const DirectionSample& one : drawn) out.push_back({one.direction, one.weight, one.pdf, false});
}

Rgb Reflector::evaluate_in_double(const Vec3f& u, const Vec3f& v) const {
  return Rgb(std::visit(
      [&](const auto& model) {
        return model.evaluate(Imath::V3d(u).normalized(), Imath::V3d(v).normalized());
      },
      brdf_));
}

std::optional<DirectionSample> Reflector::sample_nonspecular(const Vec3f& u, const Uniforms& xi) const {
  if (!(cosine_fraction_ > 0)) return reflectance::sample(scheme_, brdf_, u, xi);
  if (xi.choice < cosine_fraction_) {
    auto drawn = DiffuseScheme().sample(brdf_, u, xi);
    if (!drawn) return std::nullopt;
    const float pdf = mixed(drawn->direction, reflectance::pdf(scheme_, brdf_, u, drawn->direction));
    return DirectionSample{drawn->direction, drawn->weight * (drawn->pdf / pdf), pdf};
  }
  const auto drawn = reflectance::sample(scheme_, brdf_, u, rescale(xi, cosine_fraction_));
  if (!drawn) return std::nullopt;
  const float pdf = mixed(drawn->direction, drawn->pdf);
  return DirectionSample{drawn->direction, drawn->weight * (drawn->pdf / pdf), pdf};
}

}  // namespace reflectance
