// Series, arcs and phases of single models.
#include "renderer/reflectance/beardmaxwell.h"
#include "renderer/reflectance/granier.h"
#include "renderer/reflectance/he.h"
#include "renderer/reflectance/poulin.h"
#include "renderer/reflectance/strauss.h"
#include "tests/stability/hard_case.h"

namespace test {
namespace {

namespace glsl = reflectance::glsl;

/// Sums g^m e^-g/(m! m) e^(-b/m) over m, term by term.
template <class R>
R naive_series(R g, R b) {
  R power = 1;
  R sum = 0;
  for (int m = 1; m < 2000000; ++m) {
    power *= g / R(m);
    sum += power / R(m) * std::exp(-b / R(m));
    if (R(m) > g && !(power > 1e-9F * sum)) break;
  }
  return std::exp(-g) * sum;
}

Errors he_series() {
  return compare(
      numbers(1e-6F, 1e6F, 300), [](auto g) { return glsl::HeFormula<decltype(g)>().kirchhoff_sum(g, g); },
      [](auto g) { return naive_series(g, g); });
}

/// Tests the log of the largest term by Stirling, with the exponent as a sum of large terms.
Errors he_one_term() {
  return compare(
      numbers(100, 1e6F, 1000),
      [](auto g) {
        using R = decltype(g);
        return glsl::HeFormula<R>().kirchhoff_term(std::floor(g), g, R(0), g - std::floor(g));
      },
      [](auto g) {
        using R = decltype(g);
        const R m = std::floor(g);
        return std::exp(m * std::log(g) - g - std::lgamma(m + 1)) / m;
      });
}

Errors cauchy_scale() {
  std::vector<float> widths = numbers(0.99F, 1.01F);
  widths.push_back(1);
  return compare(
      widths, [](auto sigma) { return glsl::BeardMaxwellFormula<decltype(sigma)>().cauchy_scale(sigma); },
      [](auto sigma) {
        using R = decltype(sigma);
        const R a2 = 1 - sigma * sigma;
        const R a = std::sqrt(std::abs(a2));
        const R integral = a2 > 0 ? std::log((1 + a) / sigma) / a - 1 : std::atan(a) / a - 1;
        return a2 / (2 * glsl::Pi<R> * integral);
      });
}

Errors strauss_grazing() {
  return compare(
      numbers(1e-6F, 1e-2F), [](auto y) { return glsl::StraussFormula<decltype(y)>().strauss_shadowing(y); },
      [](auto y) {
        using R = decltype(y);
        const R kg = R(1.01);
        const R x = 1 - y;
        const R at_grazing = 1 / ((1 - kg) * (1 - kg));
        return (at_grazing - 1 / ((x - kg) * (x - kg))) / (at_grazing - 1 / (kg * kg));
      });
}

/// Tests the last visible angle of an arc, from the direction's elevation.
Errors poulin_grazing() {
  return compare(
      numbers(1e-6F, 1e-2F),
      [](auto elevation) {
        using R = decltype(elevation);
        return glsl::PoulinFormula<R>()
            .seen_from_right(std::cos(elevation), std::sin(elevation), R(2), R(0))
            .high;
      },
      [](auto elevation) {
        using R = decltype(elevation);
        const R psi = std::acos(std::sin(elevation));
        return psi - std::asin(1 - 2 * std::cos(psi));
      });
}

/// Tests the integral of cos^2 over an arc of length d about the top.
Errors poulin_short_arcs() {
  return compare(
      numbers(1e-6F, 1e-3F),
      [](auto d) {
        return glsl::PoulinFormula<decltype(d)>().arc_projected({0, 0, 1}, {0, 0, 1}, -d / 2, d / 2);
      },
      [](auto d) {
        // The antiderivative is taken from an end of the cylinder.
        using R = decltype(d);
        const R start = glsl::Pi<R> / 2 - d / 2;
        const R end = glsl::Pi<R> / 2 + d / 2;
        return (end - start - (std::sin(2 * end) - std::sin(2 * start)) / 2) / 2;
      });
}

/// Tests two beams of equal strength, 1e-4 to 0.1 of an order off a dark fringe.
Errors granier_dark_fringe() {
  std::vector<float> orders = numbers(1e-4F, 1e-1F);
  for (float& order : orders) order += 0.5F;
  return compare(
      orders,
      [](auto order) {
        using R = decltype(order);
        return glsl::GranierFormula<R>().two_beams(R(0.5), R(0.5), order);
      },
      [](auto order) {
        using R = decltype(order);
        return R(0.5) + R(0.5) + 2 * std::sqrt(R(0.5) * R(0.5)) * std::cos(2 * glsl::Pi<R> * order);
      });
}

}  // namespace

std::vector<HardCase> model_cases() {
  return {
      {"He's series, g from 1e-6 to 1e6", "g^m overflows, and exp(-g) is 0",
       "from the largest term both ways, with a step that fits its width", INFINITY, 1e-5, 2e-6, he_series},
      {"He's largest term, g from 100 to 1e6", "m log(g) - g - lgamma(m + 1)",
       "Loader's deviance and Stirling's error", 4, 1e-5, 1e-7, he_one_term},
      {"Beard and Maxwell's facets, sigma near 1", "a^2/(atanh(a)/a - 1) is 0/0", "its series about 1",
       INFINITY, 1e-5, 2e-7, cauchy_scale},
      {"Strauss' masking-shadowing, to 1e-6 of grazing", "1/(1 - kg)^2 - 1/(x - kg)^2",
       "the difference of squares as a product", 0.03, 1e-5, 1e-6, strauss_grazing},
      {"Poulin's cylinders, to 1e-6 of grazing", "psi - asin(1 - d cos(psi)), both near pi/2",
       "the elevation pi/2 - psi, by atan2", 0.03, 1e-5, 3e-7, poulin_grazing},
      {"Poulin's cylinders, an arc's integral as d falls to 1e-6", "a difference of sines",
       "sin(x) - x by its series", 0.1, 1e-5, 4e-8, poulin_short_arcs},
      {"Granier's beams, to 1e-4 of an order off a dark fringe", "R + T + 2 cos(2 pi order) sqrt(R T)",
       "the sum of squares of the beams' difference and of a sine", 0.14, 1e-5, 3e-7, granier_dark_fringe},
  };
}

}  // namespace test
