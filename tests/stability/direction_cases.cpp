// Every model with extreme parameters, at grazing, equal and opposite directions.
#include <functional>

#include "renderer/reflectance/beardmaxwell.h"
#include "renderer/reflectance/eon.h"
#include "renderer/reflectance/kajiya.h"
#include "renderer/reflectance/oren.h"
#include "renderer/reflectance/torrance.h"
#include "tests/reflectance/random_models.h"
#include "tests/stability/hard_case.h"

namespace test {
namespace {

namespace glsl = reflectance::glsl;
using reflectance::Vec3f;
using Vec3d = Imath::V3d;

/// Compares float with double where the value exceeds 1e-6 of its peak and the table allows no exception.
template <class Model>
double error_of(const Model& model, const std::vector<Pair>& pairs) {
  static const std::vector<Pair> usual = direction_pairs(500, 1);
  double peak = 1e-30;
  for (const auto* list : {&usual, &pairs}) {
    for (const Pair& pair : *list) peak = std::max(peak, model.evaluate(Vec3d(pair.u), Vec3d(pair.v)).x);
  }
  double worst = 0;
  for (const Pair& pair : pairs) {
    const double exact = model.evaluate(Vec3d(pair.u), Vec3d(pair.v)).x;
    const float value = model.evaluate(pair.u, pair.v).x;
    const double error = relative_error(value, exact);
    if (std::isfinite(value) && value >= 0 && exact < 1e-6 * peak) continue;
    if (error > 1e-3 && is_taken_nearby(model, pair, 0, value)) continue;
    worst = std::max(worst, error);
  }
  return worst;
}

std::vector<std::string> all_cases() {
  std::vector<std::string> cases = extreme_cases();
  for (const auto& more : {plain_cases(), stepped_cases(), hard_cases()})
    cases.insert(cases.end(), more.begin(), more.end());
  return cases;
}

double error_of_all_models(const std::vector<Pair>& pairs) {
  double worst = 0;
  for (const std::string& text : all_cases()) {
    const Brdf brdf = brdf_of(text);
    worst = std::max(worst, std::visit([&](const auto& model) { return error_of(model, pairs); }, brdf));
  }
  return worst;
}

std::vector<Pair> pairs_of(const std::vector<Directions>& list) {
  std::vector<Pair> pairs;
  for (const auto& [u, v] : list) pairs.push_back({u, v});
  return pairs;
}

Errors all_at_grazing() {
  Errors errors = compare(
      grazing(1e-12F, 1e-6F),
      [](auto u, auto v) {
        using R = Real<decltype(u)>;
        return glsl::TorranceFormula<R>().torrance_beckmann(u, v, R(0.3F));
      },
      [](auto u, auto v) {
        using R = Real<decltype(u)>;
        const R c = (u + v).normalized().z;
        const R m2 = R(0.3F) * R(0.3F);
        const R c2 = c * c;
        return std::exp((c2 - 1) / (c2 * m2)) / (m2 * c2 * c2);
      });
  errors.ours = error_of_all_models(pairs_of(grazing(1e-12F, 1e-6F, 500)));
  return errors;
}

Errors all_where_both_are_one() {
  Random random;
  std::vector<Directions> pairs;
  for (int i = 0; i < 500; ++i) {
    const Vec3f u = random.direction(random.log_uniform(1e-6F, 1));
    pairs.push_back({u, u});
  }
  Errors errors = compare(
      pairs,
      [](auto u, auto v) {
        using R = Real<decltype(u)>;
        const Imath::Vec3<R> e = u - v;
        return glsl::atan2(e.length(), (u + v).length());
      },
      [](auto u, auto v) { return std::acos(u.dot((u + v).normalized())); });
  errors.ours = error_of_all_models(pairs_of(pairs));
  return errors;
}

Errors all_where_both_are_opposite() {
  Random random;
  std::vector<Directions> pairs;
  for (int i = 0; i < 500; ++i) {
    const Vec3f u = random.direction(i % 2 == 0 ? 0 : random.uniform(0, 1));
    pairs.push_back({u, -u});
  }
  Errors errors = compare(
      pairs, [](auto u, auto) { return decltype(u.x)(0); },
      [](auto u, auto v) {
        const auto sum = u + v;
        const auto h = sum / std::sqrt(sum.dot(sum));
        return std::pow(h.z, decltype(u.x)(10));
      });
  errors.ours = error_of_all_models(pairs_of(pairs));
  return errors;
}

Errors all_at_both_ends() {
  Errors errors = compare(
      std::vector<Directions>{{{0.6F, 0, 0.8F}, {-0.6F, 0, 0.8F}}},
      [](auto, auto v) { return decltype(v.x)(0); },
      [](auto u, auto v) {
        using R = Real<decltype(u)>;
        const R a2 = R(0);
        const R c = (u + v).normalized().z;
        const R below = c * c * (a2 - 1) + 1;
        return a2 / (glsl::Pi<R> * below * below);
      });
  errors.ours = error_of_all_models(direction_pairs(2000, 3));
  return errors;
}

Errors smith_at_grazing() {
  return compare(
      grazing(1e-6F, 1e-3F),
      [](auto u, auto) {
        using R = Real<decltype(u)>;
        return u.z * glsl::KajiyaFormula<R>().smith_over_cosine(u, R(0.3F), R(0.3F));
      },
      [](auto u, auto) {
        using R = Real<decltype(u)>;
        const R a = 1 / (R(0.3F) * std::tan(std::acos(u.z)));
        const R lambda = (std::exp(-a * a) / (a * std::sqrt(glsl::Pi<R>)) - std::erfc(a)) / 2;
        return 1 / (1 + lambda);
      });
}

/// Returns pairs that graze, from the eye's side (1) or from across the normal (-1).
std::vector<Directions> grazing_pairs(float side) {
  Random random;
  std::vector<Directions> pairs;
  for (int i = 0; i < 10000; ++i) {
    const Vec3f u = random.direction(random.log_uniform(1e-6F, 1e-3F));
    const Vec3f v(side * u.x, side * u.y, random.log_uniform(1e-6F, 1e-3F));
    pairs.push_back({u, v.normalized()});
  }
  return pairs;
}

/// Tests light from the eye's side, where the fit is largest.
Errors oren_at_grazing() {
  return compare(
      grazing_pairs(1),
      [](auto u, auto v) {
        using R = Real<decltype(u)>;
        return glsl::OrenFormula<R>().oren(u, v, R(0.5F), Imath::Vec3<R>(1)).x;
      },
      [](auto u, auto v) {
        using R = Real<decltype(u)>;
        const R pi = glsl::Pi<R>;
        const R theta_u = std::acos(u.z);
        const R theta_v = std::acos(v.z);
        const R alpha = std::max(theta_u, theta_v);
        const R beta = std::min(theta_u, theta_v);
        const R cp = (u.x * v.x + u.y * v.y) / (std::sin(theta_u) * std::sin(theta_v));
        const R s2 = R(0.25F);
        const R q = s2 / (s2 + R(0.09));
        const R c1 = 1 - s2 / (2 * (s2 + R(0.33)));
        const R part = 2 * beta / pi;
        const R c2 = R(0.45) * q * (std::sin(alpha) - (cp < 0 ? part * part * part : R(0)));
        const R product = 4 * alpha * beta / (pi * pi);
        const R c3 = R(0.125) * q * product * product;
        const R direct =
            c1 + cp * c2 * std::tan(beta) + (1 - std::abs(cp)) * c3 * std::tan((alpha + beta) / 2);
        return (direct + R(0.17) * s2 / (s2 + R(0.13)) * (1 - cp * part * part)) / pi;
      });
}

/// Tests light from across the normal, where single and further scattering both vanish.
Errors eon_at_grazing() {
  return compare(
      grazing_pairs(-1),
      [](auto u, auto v) {
        using R = Real<decltype(u)>;
        return glsl::EonFormula<R>().eon(u, v, R(1), Imath::Vec3<R>(1)).x;
      },
      [](auto u, auto v) {
        using R = Real<decltype(u)>;
        const R pi = glsl::Pi<R>;
        const R scale = 1 / (R(1.5) - 2 / (3 * pi));
        const auto sine = [](R cosine) { return std::sqrt(1 - cosine * cosine); };
        const auto albedo = [&](R cosine) {
          const R s = sine(cosine);
          const R slope = s * (std::acos(cosine) - s * cosine);
          return scale * (1 + (slope + R(2) / 3 * (s / cosine * (1 - s * s * s) - s)) / pi);
        };
        const R cp = (u.x * v.x + u.y * v.y) / std::sqrt((u.x * u.x + u.y * u.y) * (v.x * v.x + v.y * v.y));
        const R single = scale * (1 + cp * sine(u.z) * sine(v.z));
        const R mean = scale * (R(5) / 3 - 28 / (15 * pi));
        return (single + (1 - albedo(u.z)) * (1 - albedo(v.z)) / (1 - mean)) / pi;
      });
}

}  // namespace

std::vector<HardCase> direction_cases() {
  return {
      {"Every model, u and v from 1e-12 to 1e-6 above the horizon",
       "Beckmann's exp(-tan^2/m^2)/cos^4 is 0/0 where h grazes", "exp(2 log1p(tan^2) - tan^2/m^2)", INFINITY,
       1e-3, 5e-4, all_at_grazing},
      {"Every model, u = v", "acos(u.h): the cosine is rounded beyond 1, or gives an angle of 3e-4",
       "atan2(|u - v|, |u + v|)", INFINITY, 1e-4, 3.2e-5, all_where_both_are_one},
      {"Every model, u + v = 0", "h = (u + v)/|u + v| is 0/0",
       "h is not normalised, and f = 0 at the horizon", INFINITY, 0, 0, all_where_both_are_opposite},
      {"Every model, every parameter at both ends", "a lobe of roughness 0 is 0/0 at h = n",
       "roughness is clamped above 0, or becomes a delta part", INFINITY, 1e-3, 8e-4, all_at_both_ends},
      {"Smith's masking, to 1e-6 of grazing", "tan(acos(cos))", "sine over cosine, and S/cos as one function",
       0.05, 1e-5, 3e-7, smith_at_grazing},
      {"Oren and Nayar's tan(beta), to 1e-6 of grazing", "tan(acos(cos)) of both directions",
       "the tangent from components, 1 - angle by atan2", 0.05, 1e-5, 4e-7, oren_at_grazing},
      {"EON across the normal, to 1e-6 of grazing", "1 + u.v - cu cv, and 1 less both albedos",
       "both differences in terms that vanish with the cosines", 50000, 1e-3, 1.2e-4, eon_at_grazing},
  };
}

}  // namespace test
