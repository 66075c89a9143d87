#include "renderer/reflectance/combine.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include <boost/container/small_vector.hpp>

#include "renderer/reflectance/brdf.h"

namespace reflectance {
namespace {

template <class Condition>
bool any_part(const std::shared_ptr<const CombinedBrdfs>& parts, Condition condition) {
  return parts && std::any_of(parts->begin(), parts->end(), [&](const CombinedBrdf& part) {
           return part.weight > 0 && condition(part.brdf);
         });
}

/// Albedo estimates of the terms, in order. They can cost as much as the BRDFs, so are made once.
using Albedos = boost::container::small_vector<float, 8>;

Albedos albedos_of(const CombinedBrdfs& parts, const Vec3f& u) {
  Albedos albedos;
  for (const CombinedBrdf& part : parts) {
    albedos.push_back(part.weight > 0 ? part.albedo_estimate(u) : 0.0F);
  }
  return albedos;
}

// Evaluates value and pdf of each term in one visit, since dispatch costs as much as a simple model.
Reflection reflection_of(const CombinedBrdfs& parts, const Albedos& albedos, const Vec3f& u, const Vec3f& v) {
  Reflection sum = {Rgb(0), 0};
  float total = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!(parts[i].weight > 0)) continue;
    total += albedos[i];
    std::visit(
        [&](const auto& model) {
          sum.value += parts[i].contribution(model.evaluate(u, v), u, v);
          if (albedos[i] > 0) sum.pdf += albedos[i] * model.pdf(u, v);
        },
        parts[i].brdf);
  }
  sum.pdf = total > 0 ? sum.pdf / total : 0;
  return sum;
}

}  // namespace

template <class Real>
Vec3<Real> Combine::evaluate(const Vec3<Real>& u, const Vec3<Real>& v) const {
  Vec3<Real> sum(0);
  if (!parts) return sum;
  for (const CombinedBrdf& part : *parts) {
    const Vec3<Real> value = std::visit([&](const auto& model) { return model.evaluate(u, v); }, part.brdf);
    sum += part.contribution(value, u, v);
  }
  return sum;
}

template Vec3<float> Combine::evaluate(const Vec3<float>& u, const Vec3<float>& v) const;
template Vec3<double> Combine::evaluate(const Vec3<double>& u, const Vec3<double>& v) const;

Rgb Combine::specular_weight(const Vec3f& u) const {
  Rgb sum(0);
  if (!parts) return sum;
  for (const CombinedBrdf& part : *parts) sum += part.specular_weight(u);
  return sum;
}

float Combine::albedo_estimate(const Vec3f& u) const {
  float sum = 0;
  if (!parts) return sum;
  for (const CombinedBrdf& part : *parts) sum += part.albedo_estimate(u);
  return sum;
}

Reflection Combine::reflect(const Vec3f& u, const Vec3f& v) const {
  return parts ? reflection_of(*parts, albedos_of(*parts, u), u, v) : Reflection{Rgb(0), 0};
}

std::optional<DirectionSample> Combine::sample(const Vec3f& u, const Uniforms& xi) const {
  if (!parts) return std::nullopt;
  const Albedos albedos = albedos_of(*parts, u);
  const float total = std::accumulate(albedos.begin(), albedos.end(), 0.0F);
  if (!(total > 0)) return std::nullopt;
  float before = 0;
  for (std::size_t i = 0; i < albedos.size(); ++i) {
    const float fraction = albedos[i] / total;
    const bool is_last = i + 1 == albedos.size();
    if (!(fraction > 0) || (xi.choice >= before + fraction && !is_last)) {
      before += fraction;
      continue;
    }
    Uniforms rest = xi;
    rest.choice = std::clamp((xi.choice - before) / fraction, 0.0F, 0x1.fffffep-1F);
    const auto drawn = std::visit([&](const auto& model) { return model.sample(u, rest); }, (*parts)[i].brdf);
    if (!drawn) return std::nullopt;
    const Vec3f& v = drawn->direction;
    const Reflection reflection = reflection_of(*parts, albedos, u, v);
    if (!(reflection.pdf > 0) || !std::isfinite(reflection.pdf)) return std::nullopt;
    return DirectionSample{v, reflection.value * (v.z / reflection.pdf), reflection.pdf};
  }
  return std::nullopt;
}

bool Combine::has_specular_part() const {
  return any_part(parts, [](const Brdf& brdf) { return reflectance::has_specular_part(brdf); });
}
bool Combine::has_diffuse_part() const {
  return any_part(parts, [](const Brdf& brdf) { return reflectance::has_diffuse_part(brdf); });
}
bool Combine::has_glossy_part() const {
  return any_part(parts, [](const Brdf& brdf) { return reflectance::has_glossy_part(brdf); });
}
bool Combine::is_anisotropic() const {
  return any_part(parts, [](const Brdf& brdf) { return reflectance::is_anisotropic(brdf); });
}

std::optional<LobeExponents> Combine::lobe_exponents() const {
  std::optional<LobeExponents> widest;
  if (!parts) return widest;
  for (const CombinedBrdf& part : *parts) {
    const auto own = reflectance::lobe_exponents(part.brdf);
    if (own && part.weight > 0 && (!widest || own->about_mirror() < widest->about_mirror())) widest = own;
  }
  return widest;
}

}  // namespace reflectance
