#include "renderer/reflectance/combine.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "renderer/reflectance/brdf.h"

namespace reflectance {
namespace {

template <class Condition>
bool any_part(const std::shared_ptr<const CombinedBrdfs>& parts, Condition condition) {
  return parts && std::any_of(parts->begin(), parts->end(), [&](const CombinedBrdf& part) {
           return part.weight > 0 && condition(part.brdf);
         });
}

}  // namespace

template <class Real>
Vec3<Real> Combine::evaluate(const Vec3<Real>& u, const Vec3<Real>& v) const {
  Vec3<Real> sum(0);
  if (!parts) return sum;
  for (const CombinedBrdf& part : *parts) {
    sum += std::visit([&](const auto& model) { return model.evaluate(u, v); }, part.brdf) * Real(part.weight);
  }
  return sum;
}

template Vec3<float> Combine::evaluate(const Vec3<float>& u, const Vec3<float>& v) const;
template Vec3<double> Combine::evaluate(const Vec3<double>& u, const Vec3<double>& v) const;

Rgb Combine::mirror(const Vec3f& u) const {
  Rgb sum(0);
  if (!parts) return sum;
  for (const CombinedBrdf& part : *parts) sum += reflectance::mirror(part.brdf, u) * part.weight;
  return sum;
}

float Combine::albedo_estimate(const Vec3f& u) const {
  float sum = 0;
  if (!parts) return sum;
  for (const CombinedBrdf& part : *parts) sum += part.albedo_estimate(u);
  return sum;
}

// One visit for all that is asked of a part, since dispatch costs as much as a simple model.
Reflection Combine::reflect(const Vec3f& u, const Vec3f& v) const {
  Reflection sum = {Rgb(0), 0};
  if (!parts) return sum;
  float albedo = 0;
  for (const CombinedBrdf& part : *parts) {
    if (!(part.weight > 0)) continue;
    std::visit(
        [&](const auto& model) {
          const float part_albedo = part.weight * model.albedo_estimate(u);
          albedo += part_albedo;
          sum.value += model.evaluate(u, v) * part.weight;
          if (part_albedo > 0) sum.density += part_albedo * model.density(u, v);
        },
        part.brdf);
  }
  sum.density = albedo > 0 ? sum.density / albedo : 0;
  return sum;
}

std::optional<DirectionSample> Combine::sample(const Vec3f& u, const Uniforms& xi) const {
  const float total = albedo_estimate(u);
  if (!(total > 0)) return std::nullopt;
  float before = 0;
  for (const CombinedBrdf& part : *parts) {
    const float share = part.albedo_estimate(u) / total;
    const bool is_last = &part == &parts->back();
    if (!(share > 0) || (xi.choice >= before + share && !is_last)) {
      before += share;
      continue;
    }
    Uniforms rest = xi;
    rest.choice = std::clamp((xi.choice - before) / share, 0.0F, 0x1.fffffep-1F);
    const auto drawn = std::visit([&](const auto& model) { return model.sample(u, rest); }, part.brdf);
    if (!drawn) return std::nullopt;
    const Reflection reflection = reflect(u, drawn->direction);
    if (!(reflection.density > 0) || !std::isfinite(reflection.density)) return std::nullopt;
    return DirectionSample{drawn->direction, reflection.value * (drawn->direction.z / reflection.density),
                           reflection.density};
  }
  return std::nullopt;
}

bool Combine::has_mirror() const {
  return any_part(parts, [](const Brdf& brdf) { return reflectance::has_mirror(brdf); });
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
