// Fresnel reflectance and transmittance.
#include "renderer/reflectance/coupled.h"
#include "renderer/reflectance/hanrahan.h"
#include "renderer/reflectance/torrance.h"
#include "tests/reflectance/brdf_cases.h"
#include "tests/stability/hard_case.h"

namespace test {
namespace {

namespace glsl = reflectance::glsl;
using reflectance::Vec3f;

/// The textbook formula, from eta and k with the sum of a^2 and b^2.
template <class R>
R textbook_fresnel(R c, R n, R k) {
  const R c2 = c * c;
  const R s2 = 1 - c2;
  const R t0 = n * n - k * k - s2;
  const R a2_and_b2 = std::sqrt(t0 * t0 + 4 * n * n * k * k);
  const R t1 = a2_and_b2 + c2;
  const R a = std::sqrt((a2_and_b2 + t0) / 2);
  const R t2 = 2 * c * a;
  const R rs = (t1 - t2) / (t1 + t2);
  const R t3 = c2 * a2_and_b2 + s2 * s2;
  const R t4 = t2 * s2;
  return rs * (1 + (t3 - t4) / (t3 + t4)) / 2;
}

template <class R>
R fresnel(R c, R n, R k) {
  return glsl::TorranceFormula<R>().fresnel(c, n, k);
}

Errors metals() {
  Errors errors;
  for (const float n : {0.001F, 0.01F, 0.1F, 1.0F}) {
    for (const float k : {3.0F, 10.0F, 30.0F, 100.0F}) {
      errors.include(compare(
          numbers(1e-6F, 1, 1000), [&](auto c) { return fresnel(c, decltype(c)(n), decltype(c)(k)); },
          [&](auto c) { return textbook_fresnel(c, decltype(c)(n), decltype(c)(k)); }));
    }
  }
  return errors;
}

Errors index_near_1() {
  return compare(
      numbers(0.01F, 1), [](auto c) { return fresnel(c, decltype(c)(1.0001F), decltype(c)(0)); },
      [](auto c) {
        const auto g = std::sqrt(decltype(c)(1.0001F) * decltype(c)(1.0001F) - 1 + c * c);
        const auto a = (g - c) / (g + c);
        const auto b = (c * (g + c) - 1) / (c * (g - c) + 1);
        return a * a * (1 + b * b) / 2;
      });
}

Errors index_near_0() {
  Random random;
  std::vector<Directions> pairs;
  for (int i = 0; i < 10000; ++i) {
    const Vec3f u = random.direction(random.uniform(0.3F, 1));
    pairs.push_back({u, i % 10 == 0 ? u : random.near(u, random.log_uniform(1e-7F, 0.1F))});
  }
  return compare(
      pairs,
      [](auto u, auto v) {
        using R = Real<decltype(u)>;
        return glsl::TorranceFormula<R>().fresnel_at_half(u, v, R(1e-3F), R(1e-6F));
      },
      [](auto u, auto v) {
        using R = Real<decltype(u)>;
        return textbook_fresnel(std::min(R(1), u.dot((u + v).normalized())), R(1e-3F), R(1e-6F));
      });
}

Errors grazing_transmittance() {
  return compare(
      numbers(1e-6F, 1e-2F),
      [](auto c) { return glsl::HanrahanFormula<decltype(c)>().transmittance(c, decltype(c)(1.5)); },
      [](auto c) { return 1 - textbook_fresnel(c, decltype(c)(1.5), decltype(c)(0)); });
}

Errors schlick_at_grazing() {
  return compare(
      numbers(1e-6F, 1e-2F),
      [](auto c) { return glsl::CoupledFormula<decltype(c)>().one_minus_fifth_power(c); },
      [](auto c) { return 1 - std::pow(1 - c, decltype(c)(5)); });
}

/// Returns the albedo of a diffuse surface under a specular coat, for u: exactly 1. Integrates over v by the
/// midpoint rule in v.z.
template <class Matte>
double furnace(const reflectance::Coupled& coupled, float cosine, Matte matte) {
  constexpr int Steps = 2000;
  const Vec3f u = reflectance::from_angles(cosine, std::sqrt((1 - cosine) * (1 + cosine)), 0);
  double sum = 0;
  for (int i = 0; i < Steps; ++i) {
    const float z = (static_cast<float>(i) + 0.5F) / Steps;
    const Vec3f v(0, std::sqrt((1 - z) * (1 + z)), z);
    sum += static_cast<double>(matte(u, v) * z) * 2 * M_PI / Steps;
  }
  return sum + static_cast<double>(coupled.specular_weight(u).x);
}

Errors white_furnace() {
  const auto coupled = std::get<reflectance::Coupled>(brdf_of("coupled Rm=1 R0=0.05"));
  Errors errors;
  for (const float cosine : numbers(1e-6F, 1, 100)) {
    const double ours = furnace(coupled, cosine, [&](auto u, auto v) { return coupled.evaluate(u, v).x; });
    const double naive = furnace(coupled, cosine, [](auto, auto) { return 1 / reflectance::Pi; });
    errors.ours = std::max(errors.ours, std::abs(ours - 1));
    errors.naive = std::max(errors.naive, std::abs(naive - 1));
  }
  return errors;
}

}  // namespace

std::vector<HardCase> fresnel_cases() {
  return {
      {"Metals, n from 0.001 to 1 and kappa to 100",
       "a^2 from the sum of n^2 - k^2 - sin^2 and its magnitude, which cancel",
       "only the larger of a and b so, the other from a b = n k", 1e-4, 2e-5, 6e-6, metals},
      {"Dielectric with an index of 1.0001", "g - c, of g^2 = n^2 - 1 + c^2", "(n^2 - 1)/(g + c)", 9e-4, 1e-5,
       7e-7, index_near_1},
      {"Index of 0.001 + 1e-6i, u near v",
       "sin^2 = 1 - c^2 has no digits left, and total reflection starts at 1e-6", "sin^2 = |u - v|^2/4", 0.03,
       1e-5, 9e-7, index_near_0},
      {"Transmittance of glass, to 1e-6 of grazing", "1 - F",
       "4 a c/(a + c)^2 and its equivalent for the other polarisation", 0.03, 1e-5, 3e-7,
       grazing_transmittance},
      {"Schlick's 1 - (1 - c)^5, to 1e-6 of grazing", "the difference", "a polynomial c (5 - 10 c + ...)",
       0.03, 1e-5, 1e-7, schlick_at_grazing},
      {"White furnace: diffuse under a specular coat, to 1e-6 of grazing",
       "kd/pi + Fresnel reflection gains energy", "`coupled` gives the diffuse part what the coat transmits",
       1, 1e-5, 2e-7, white_furnace},
  };
}

}  // namespace test
