// Narrow lobes, for which a cosine near 1 has lost its digits.
#include "renderer/reflectance/ashikhmin.h"
#include "renderer/reflectance/blinn.h"
#include "renderer/reflectance/hanrahan.h"
#include "renderer/reflectance/lafortune.h"
#include "renderer/reflectance/schlick.h"
#include "renderer/reflectance/strauss.h"
#include "renderer/reflectance/torrance.h"
#include "renderer/reflectance/ward.h"
#include "tests/reflectance/brdf_cases.h"
#include "tests/stability/hard_case.h"

namespace test {
namespace {

namespace glsl = reflectance::glsl;
using reflectance::Vec3f;

Errors phong_lobe() {
  return compare(
      about_the_mirror(0.01F),
      [](auto u, auto v) {
        using R = Real<decltype(u)>;
        return glsl::CommonFormulas<R>().mirror_power(u, v, R(1e5));
      },
      [](auto u, auto v) {
        using R = Real<decltype(u)>;
        const Imath::Vec3<R> r(-v.x, -v.y, v.z);
        return std::pow(std::max(R(0), u.dot(r)), R(1e5));
      },
      1e-6);
}

Errors blinn_lobe() {
  return compare(
      about_the_mirror(0.02F),
      [](auto u, auto v) {
        using R = Real<decltype(u)>;
        return glsl::CommonFormulas<R>().half_power(u, v, R(1e5));
      },
      [](auto u, auto v) {
        using R = Real<decltype(u)>;
        return std::pow((u + v).normalized().z, R(1e5));
      },
      1e-6);
}

Errors beckmann_lobe() {
  return compare(
      about_the_mirror(3e-4F),
      [](auto u, auto v) {
        using R = Real<decltype(u)>;
        return glsl::TorranceFormula<R>().torrance_beckmann(u, v, R(1e-4F));
      },
      [](auto u, auto v) {
        using R = Real<decltype(u)>;
        const R m2 = R(1e-4F) * R(1e-4F);
        const R c = (u + v).normalized().z;
        const R c2 = c * c;
        return std::exp((c2 - 1) / (c2 * m2)) / (m2 * c2 * c2);
      },
      1e2);
}

Errors ward_lobe() {
  return compare(
      about_the_mirror(3e-4F),
      [](auto u, auto v) {
        using R = Real<decltype(u)>;
        const Imath::Vec3<R> one(1);
        return glsl::WardFormula<R>().ward(u, v, R(1e-4F), R(1e-3F), one, R(0) * one).x;
      },
      [](auto u, auto v) {
        using R = Real<decltype(u)>;
        const R sx = R(1e-4F);
        const R sy = R(1e-3F);
        const Imath::Vec3<R> h = (u + v).normalized();
        const R tangent = std::tan(std::acos(h.z));
        const R phi = std::atan2(h.y, h.x);
        const R x = std::cos(phi) / sx;
        const R y = std::sin(phi) / sy;
        return std::exp(-tangent * tangent * (x * x + y * y)) /
               (4 * glsl::Pi<R> * sx * sy * std::sqrt(u.z * v.z));
      },
      1);
}

Errors power_directions() {
  constexpr float N = 1e6F;
  const auto exact = [](float xi) {
    const double x = -std::expm1(std::log1p(-static_cast<double>(xi)) / (N + 1));
    return std::sqrt(x * (2 - x));
  };
  const auto naive = [](auto xi) {
    using R = Real<decltype(xi)>;
    const R cosine = std::pow(1 - xi, 1 / (N + R(1)));
    return std::sqrt(1 - cosine * cosine);
  };
  Errors errors;
  for (const float xi : numbers(0.01F, 0.99F)) {
    const float ours = reflectance::power_direction(N, {xi, 0}).x;
    errors.include({relative_error(ours, exact(xi)), relative_error(naive(xi), exact(xi)),
                    relative_error(naive(static_cast<double>(xi)), exact(xi))});
  }
  return errors;
}

/// Returns f cos(theta_v) / pdf, with f from v and the pdf from the sampled h.
template <class R>
R naive_weight(const Imath::Vec3<R>& u, R xi, R phi, R n) {
  const R cosine = std::pow(1 - xi, 1 / (n + 1));
  const R sine = std::sqrt(1 - cosine * cosine);
  const Imath::Vec3<R> h(sine * std::cos(phi), sine * std::sin(phi), cosine);
  const R uh = u.dot(h);
  const Imath::Vec3<R> v = 2 * uh * h - u;
  const R f = std::pow((u + v).normalized().z, n);
  const R pdf = (n + 1) / (2 * glsl::Pi<R>)*std::pow(cosine, n) / (4 * uh);
  return f * v.z / pdf;
}

Errors lobe_weights() {
  Random random;
  const auto blinn = std::get<reflectance::Blinn>(brdf_of("blinn n=1000000"));
  Errors errors;
  for (int i = 0; i < 10000; ++i) {
    const Vec3f u = random.direction(random.uniform(0.2F, 1));
    const float xi = random.uniform(0, 0.999F);
    const float phi = random.uniform(0, 2 * reflectance::Pi);
    const Vec3f v = blinn.lobe_direction(u, {xi, phi / (2 * reflectance::Pi)});
    const double c = Imath::V3d(u + v).length() / 2;
    const double exact = 8 * M_PI * c / (1e6 + 1) * static_cast<double>(v.z);
    errors.include({relative_error(blinn.lobe_ratio(u, v), exact),
                    relative_error(naive_weight<float>(u, xi, phi, 1e6F), exact),
                    relative_error(naive_weight<double>(Imath::V3d(u).normalized(), xi, phi, 1e6), exact)});
  }
  return errors;
}

Errors schlick_zenith() {
  return compare(
      about_the_mirror(3e-4F),
      [](auto u, auto v) {
        using R = Real<decltype(u)>;
        return glsl::SchlickFormula<R>().schlick_zenith(u + v, R(1e-8F));
      },
      [](auto u, auto v) {
        using R = Real<decltype(u)>;
        const R r = R(1e-8F);
        const R t = (u + v).normalized().z;
        const R below = 1 + r * t * t - t * t;
        return r / (below * below);
      });
}

std::vector<Directions> with_exact_mirrors(std::vector<Directions> pairs) {
  for (std::size_t i = 0; i < pairs.size(); i += 10) pairs[i].v = reflectance::mirrored(pairs[i].u);
  return pairs;
}

Errors schlick_azimuth() {
  return compare(
      with_exact_mirrors(about_the_mirror(0.3F)),
      [](auto u, auto v) {
        using R = Real<decltype(u)>;
        return glsl::SchlickFormula<R>().schlick_azimuth(u + v,
                                                         glsl::SchlickFormula<R>().schlick_isotropy(0));
      },
      [](auto u, auto v) {
        using R = Real<decltype(u)>;
        const Imath::Vec3<R> h = (u + v).normalized();
        const R w = h.x / std::sqrt(h.x * h.x + h.y * h.y);
        const R p = R(1e-4F);
        return std::sqrt(p / (p * p - p * p * w * w + w * w));
      });
}

Errors schlick_mirror_and_lobe() {
  const auto schlick = std::get<reflectance::Schlick>(brdf_of("schlick SC=0.5 Sr=0 Ly=true DC=0.5 Dr=0.1"));
  return compare(
      with_exact_mirrors(about_the_mirror(0.1F)), [&](auto u, auto v) { return schlick.evaluate(u, v).x; },
      [&](auto u, auto v) {
        using R = Real<decltype(u)>;
        const R r = R(0);
        const R t = (u + v).normalized().z;
        const R below = 1 + r * t * t - t * t;
        return schlick.evaluate(u, v).x + r / (below * below);
      });
}

Errors ashikhmin_pole() {
  return compare(
      with_exact_mirrors(about_the_mirror(0.02F)),
      [](auto u, auto v) {
        using R = Real<decltype(u)>;
        return glsl::AshikhminFormula<R>().ashikhmin_power(u + v, R(1e4), R(1e5));
      },
      [](auto u, auto v) {
        using R = Real<decltype(u)>;
        const Imath::Vec3<R> h = (u + v).normalized();
        return std::pow(h.z, (R(1e4) * h.x * h.x + R(1e5) * h.y * h.y) / (1 - h.z * h.z));
      },
      1e-6);
}

Errors lafortune_behind() {
  std::vector<Directions> pairs = grazing(0.01F, 1);
  const auto cosine = [](auto u, auto v) { return u.z * v.z - u.x * v.x - u.y * v.y; };
  std::erase_if(pairs, [&](const Directions& pair) { return std::abs(cosine(pair.u, pair.v)) < 0.01F; });
  return compare(
      pairs,
      [](auto u, auto v) {
        using R = Real<decltype(u)>;
        return glsl::LafortuneFormula<R>().lafortune_lobe(u, v, R(2.5), R(-1), R(-1), R(1));
      },
      [&](auto u, auto v) { return std::pow(cosine(u, v), Real<decltype(u)>(2.5)); });
}

Errors strauss_mirror() {
  return compare(
      about_the_mirror(0.005F),
      [](auto u, auto v) {
        using R = Real<decltype(u)>;
        const Imath::Vec3<R> one(1);
        return glsl::StraussFormula<R>().strauss(u, v, R(1), R(1), one, one).x;
      },
      [](auto u, auto v) {
        using R = Real<decltype(u)>;
        const R exponent = 3 / (1 - R(1));
        const Imath::Vec3<R> r(-v.x, -v.y, v.z);
        return (exponent + 2) / (2 * glsl::Pi<R>)*std::pow(std::max(R(0), u.dot(r)), exponent);
      },
      1e-2);
}

Errors forward_scattering() {
  Random random;
  std::vector<Directions> pairs;
  for (int i = 0; i < 10000; ++i) {
    const Vec3f u = random.direction(random.uniform(0.1F, 1));
    pairs.push_back({u, random.near(-u, random.log_uniform(1e-4F, 0.1F))});
  }
  return compare(
      pairs,
      [](auto u, auto v) {
        using R = Real<decltype(u)>;
        return glsl::HanrahanFormula<R>().henyey_greenstein(u, v, R(0.99F));
      },
      [](auto u, auto v) {
        using R = Real<decltype(u)>;
        const R g = R(0.99F);
        return (1 - g * g) / (4 * glsl::Pi<R> * std::pow(1 + g * g + 2 * g * u.dot(v), R(1.5)));
      });
}

}  // namespace

std::vector<HardCase> lobe_cases() {
  return {
      {"Phong's lobe, n = 1e5", "pow(u.r, n): the cosine is rounded to 6e-8, and so is the length of u",
       "exp(n log1p(-d^2/2)), d the distance of u and the mirror direction", 0.02, 1e-5, 2e-6, phong_lobe},
      {"Blinn's lobe, n = 1e5", "pow(n.h, n) of a normalised h", "exp(-n/2 log1p(tan^2)), h not normalised",
       0.01, 1e-5, 4e-6, blinn_lobe},
      {"Beckmann's facets, roughness 1e-4", "tan^2 = (1 - c^2)/c^2 of c = n.h", "tan^2 = (hx^2 + hy^2)/hz^2",
       9e5, 1e-5, 4e-6, beckmann_lobe},
      {"Ward's lobe, slopes 1e-4 and 1e-3", "the angle acos(n.h) and its tangent",
       "hx/hz and hy/hz, without angles", 6e5, 1e-5, 3e-6, ward_lobe},
      {"Sampling of a power lobe, n = 1e6", "sin = sqrt(1 - cos^2), cos = xi^(1/(n+1))",
       "1 - cos by expm1 and log1p", 1, 1e-5, 2e-7, power_directions},
      {"Sample weight of the lobe n = 1e6", "f cos / pdf: two large values with different rounding",
       "their ratio in closed form", 0.1, 1e-5, 2e-7, lobe_weights},
      {"Schlick's layer, roughness 1e-8", "r/(1 + r t^2 - t^2)^2 of t = n.h",
       "hx^2 + hy^2 and hz^2 in place of t", INFINITY, 1e-5, 6e-7, schlick_zenith},
      {"Schlick's layer, isotropy 0, h = n", "the azimuth of h is 0/0", "1 where h = n; p is at least 1e-4",
       INFINITY, 1e-5, 2e-7, schlick_azimuth},
      {"Mirror beside a lobe: Schlick, Sr = 0 over Dr = 0.1", "a lobe of roughness 0 is 0/0 at h = n",
       "`specular_weight` returns the delta part, `evaluate` excludes it", INFINITY, 1e-5, 1e-6,
       schlick_mirror_and_lobe},
      {"Ashikhmin's lobe, exponents 1e4 and 1e5", "pow(n.h, (ex hx^2 + ey hy^2)/(1 - hz^2)), 0/0 where h = n",
       "1 - hz^2 as hx^2 + hy^2, the cosine as in Blinn's; 1 where h = n", 1e-3, 2e-5, 5e-6, ashikhmin_pole},
      {"Lafortune's lobe from behind, n = 2.5", "pow of a negative cosine", "0 unless the cosine is above 0",
       INFINITY, 2e-5, 6e-6, lafortune_behind},
      {"Strauss' metal, smoothness 1", "the exponent 3/(1 - s) is infinite", "the exponent is at most 1e5",
       INFINITY, 1e-5, 4e-7, strauss_mirror},
      {"Forward scattering, g = 0.99", "1 + g^2 - 2 g cos", "(1 - g)^2 + g |u + v|^2", 6e-3, 1e-5, 3e-7,
       forward_scattering},
  };
}

}  // namespace test
