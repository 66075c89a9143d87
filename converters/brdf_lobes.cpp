#include "converters/brdf_lobes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "converters/brdf_arguments.h"
#include "grf/keywords.h"

namespace convert {

using grf::Vec3d;

namespace {

using Arguments = BrdfArguments;

constexpr double Mirror = std::numeric_limits<double>::infinity();
const BrdfLobes Unknown = {Vec3d(0.5), Vec3d(0), 0};

double mean(double a, double b) { return std::sqrt(std::max(a, 0.0) * std::max(b, 0.0)); }
double strength(const Vec3d& v) { return v.x + v.y + v.z; }

/// Converts a Phong exponent, about the mirror direction, to a Blinn-Phong exponent.
double to_blinn_phong_exponent(double exponent) { return 4 * exponent; }

BrdfLobes diffuse(const Vec3d& albedo) { return {albedo, Vec3d(0), 0}; }

// The lobe is not normalised: the factor is its albedo at normal incidence.
BrdfLobes phong(const Arguments& a) {
  const double n = a.number({"n"}, 100);
  return {a.colour({"kd"}, 0.6), a.colour({"ks"}, 0.4) * (2 * std::numbers::pi / (n + 2)),
          to_blinn_phong_exponent(n)};
}

BrdfLobes blinn(const Arguments& a) {
  const double n = a.number({"n"}, 100);
  const double fraction = 8 * std::numbers::pi * (n + std::exp2(-n / 2)) / ((n + 2) * (n + 4));
  return {a.colour({"kd"}, 0.6), a.colour({"ks"}, 0.4) * fraction, n};
}

BrdfLobes lewis(const Arguments& a) {
  return {a.colour({"kd"}, 0.6), a.colour({"ks"}, 0.4), to_blinn_phong_exponent(a.number({"n"}, 100))};
}

BrdfLobes lafortune(const Arguments& a) {
  const double n = a.number({"n"}, 20);
  const double fraction = 2 * std::numbers::pi * std::pow(std::max(a.number({"Cz"}, 1), 0.0), n) / (n + 2);
  return {a.colour({"kp", "kd"}, 0.5), Vec3d(fraction), to_blinn_phong_exponent(n)};
}

BrdfLobes ward(const Arguments& a) {
  const double sx = a.number({"sx"}, 0.2);
  return {a.colour({"kd"}, 0.5), a.colour({"ks"}, 0.5), exponent_of(mean(sx, a.number({"sy"}, sx)))};
}

BrdfLobes torrance(const Arguments& a) {
  return {a.colour({"kd"}, 0.3), a.colour({"ks"}, 0.7) * a.fresnel(1.5),
          exponent_of(a.number({"rough", "m"}, 0.35))};
}

BrdfLobes ashikhmin(const Arguments& a) {
  const double ex = a.number({"ex", "nu"}, 25);
  const Vec3d facet = a.colour({"Rs", "ks"}, 0.39);
  return {a.colour({"Rd", "kd"}, 0.6) * (Vec3d(1) - facet), facet, mean(ex, a.number({"ey", "nv"}, ex))};
}

BrdfLobes coupled(const Arguments& a) {
  const Vec3d polish = a.colour({"R0", "Ro"}, 0.05);
  return {a.colour({"Rm"}, 0.5) * (Vec3d(1) - polish), polish, Mirror};
}

// The microfacet distribution is GGX with alpha^2 = Sr.
BrdfLobes schlick(const Arguments& a) {
  const Vec3d outer = a.colour({"SC"}, 0.7);
  const Vec3d below = a.flag("Ly") ? a.colour({"DC"}, 0.5) * (Vec3d(1) - outer) : Vec3d(0);
  return {below, outer, exponent_of(std::sqrt(a.number({"Sr"}, 0.31)))};
}

BrdfLobes strauss(const Arguments& a) {
  const double s = a.number({"s"}, 0.5);
  const double m = a.number({"m"}, 0);
  const Vec3d kd = a.colour({"kd"}, 0.5);
  const double most = std::max({kd.x, kd.y, kd.z});
  const Vec3d tint = most > 0 ? Vec3d(1) + (kd / most - Vec3d(1)) * m : Vec3d(1);
  const double smooth = s * s * s;
  return {kd * ((1 - m * s) * (1 - smooth)), a.colour({"ks"}, 0.5) * tint * smooth,
          to_blinn_phong_exponent(3 / std::max(1 - s, 3e-5))};
}

// The mean of sin^2 is r^2/2 over the disc, and 2/(n + 2) over a Phong lobe.
BrdfLobes neumann(const Arguments& a) {
  const double r = a.number({"r"}, 0.2);
  const double square = std::max(r * a.number({"ry"}, r), 1e-12);
  return {a.colour({"kd"}, 0), a.colour({"ks"}, 1), to_blinn_phong_exponent(4 / square - 2)};
}

BrdfLobes beardmaxwell(const Arguments& a) {
  return {a.colour({"Rd"}, 0.3) + a.colour({"Rv"}, 0.1), a.colour({"Rs"}, 1) * a.fresnel(1.65),
          exponent_of(a.number({"sigma"}, 0.3))};
}

BrdfLobes kajiya(const Arguments& a) {
  const double length = mean(a.number({"taux"}, 1), a.number({"tauy"}, 4));
  return {a.colour({"kd"}, 0), a.colour({"ks"}, 1) * a.fresnel(0),
          exponent_of(2 * a.number({"sigma"}, 0.2) / length)};
}

BrdfLobes wave(const Arguments& a) {
  return {a.colour({"kd"}, 0), a.colour({"ks"}, 1) * a.fresnel(0),
          exponent_of(2 * a.number({"sigma"}, 0.2) / a.number({"tau"}, 2))};
}

// Single scattering at normal incidence that leaves the layer by refraction: half the integral of c/(1 + c)
// over the cosines c inside the critical angle, with the depth of the layer and its phase function.
BrdfLobes hanrahan(const Arguments& a) {
  const double n = std::max(a.number({"nreal"}, 1.4), 1.0);
  const double g = a.number({"g"}, 0.25);
  const double critical = std::sqrt(1 - 1 / (n * n));
  const double isotropic = (1 - critical - std::log(2 / (1 + critical))) / 2;
  const double backwards = (1 - g) / ((1 + g) * (1 + g));
  const double kept = -std::expm1(-2 * a.number({"depth"}, 10));
  const double facet = a.fresnel(1.4);
  const Vec3d scattered = a.colour({"albedo"}, 0.8) * (isotropic * backwards * kept);
  return {(a.colour({"kd"}, 0.2) + scattered) * ((1 - facet) * (1 - facet)), a.colour({"ks"}, 1) * facet,
          exponent_of(a.number({"rough"}, 0.3))};
}

// Light transmitted by the film is reflected at its base, and spread by refraction as it leaves.
BrdfLobes granier(const Arguments& a) {
  const Vec3d n = a.colour({"nreal"}, 1.51);
  const Vec3d root = (n - Vec3d(1)) / (n + Vec3d(1));
  const Vec3d film = root * root;
  const Vec3d outer = a.colour({"ks"}, 1) * film;
  const Vec3d inner = a.colour({"kt"}, 0.8) * (Vec3d(1) - film) * (Vec3d(1) - film);
  const bool inner_is_stronger = strength(inner) > strength(outer);
  return {a.colour({"kd"}, 0), outer + inner,
          inner_is_stronger ? a.number({"m"}, 20) / (n.y * n.y) : a.number({"n"}, 100)};
}

BrdfLobes poulin(const Arguments& a) {
  return {a.colour({"kd"}, 0.5), a.colour({"ks"}, 0.5), a.number({"n"}, 50)};
}

// What its facets reflect once, and the mean albedo over the hemisphere with what they scatter to each other.
BrdfLobes eon(const Arguments& a) {
  const double rough = a.number({"rough"}, 0.5);
  const double once = (1 + (2 / 3.0 - 28 / (15 * std::numbers::pi)) * rough) /
                      (1 + (1 / 2.0 - 2 / (3 * std::numbers::pi)) * rough);
  const Vec3d kd = a.colour({"kd"}, 0.5);
  return diffuse(kd * once / (Vec3d(1) - kd * (1 - once)));
}

/// The reflectance at normal incidence of a film over a base, for one wavelength (Airy's sum).
double film_reflectance(double thickness, double film, const std::complex<double>& base, double wavelength) {
  const double front = (1 - film) / (1 + film);
  const std::complex<double> back = (film - base) / (film + base);
  const std::complex<double> delayed =
      back * std::polar(1.0, 4 * std::numbers::pi * film * thickness / wavelength);
  return std::norm((front + delayed) / (1.0 + front * delayed));
}

BrdfLobes thinfilm(const Arguments& a) {
  const Vec3d n = a.colour({"nreal", "ior"}, 1.5);
  const Vec3d k = a.colour({"nimag"}, 0);
  const Vec3d wavelengths(610, 550, 465);
  Vec3d normal;
  for (int i = 0; i < 3; ++i) {
    normal[i] = film_reflectance(a.number({"thickness", "d"}, 300), a.number({"film"}, 1.33), {n[i], k[i]},
                                 wavelengths[i]);
  }
  const double along = a.number({"alpha", "ax"}, 0.1);
  return {Vec3d(0), a.colour({"ks"}, 1) * normal, 2 / (along * a.number({"ay"}, along)) - 2};
}

// The exponent is that of the geometric mean of both roughnesses.
BrdfLobes ggx(const Arguments& a) {
  Vec3d normal = a.colour({"F0"}, 0);
  if (strength(normal) <= 0) {
    const Vec3d n = a.colour({"nreal", "ior"}, 1.5);
    const Vec3d k = a.colour({"nimag"}, 0);
    const Vec3d less = n - Vec3d(1);
    const Vec3d more = n + Vec3d(1);
    normal = (less * less + k * k) / (more * more + k * k);
  }
  const double along = a.number({"alpha", "ax"}, 0.3);
  const double less = 1 - a.number({"anisotropy"}, 0);
  const double across = std::max(1e-4, a.number({"ay"}, along) * less);
  return {Vec3d(0), a.colour({"ks"}, 1) * normal,
          exponent_of(mean(along, across) * std::sqrt(2 / (1 + less * less)))};
}

// The albedo's fit (MaterialX 1.39), with its mean over the hemisphere by the midpoint rule.
BrdfLobes sheen(const Arguments& a) {
  const double r = a.number({"rough"}, 0.3);
  const double width = r * (0.0206607 + 1.58491 * r) / (0.0379424 + r * (1.32227 + r));
  const double centre = r * (-0.193854 + r * (-1.14885 + r * (1.7932 - 0.95943 * r * r))) / (0.046391 + r);
  const double base = r * (0.000654023 + (-0.0207818 + 0.119681 * r) * r) / (1.26264 + r * (-1.92021 + r));
  constexpr int Count = 1024;
  double albedo = 0;
  for (int i = 0; i < Count; ++i) {
    const double c = (i + 0.5) / Count;
    const double place = (c - centre) / width;
    const double value = std::exp(-place * place / 2) / (width * std::sqrt(2 * std::numbers::pi)) + base;
    albedo += 2 * c * value / Count;
  }
  return diffuse(a.colour({"ks"}, 1) * albedo);
}

Vec3d in_unit(const Vec3d& v) {
  const auto clamp = [](double x) { return std::isfinite(x) ? std::clamp(x, 0.0, 1.0) : 0.0; };
  return {clamp(v.x), clamp(v.y), clamp(v.z)};
}

// Coats and fibres are lost.
BrdfLobes gltf(const Arguments& a) {
  const double root = (a.number({"ior"}, 1.5) - 1) / (a.number({"ior"}, 1.5) + 1);
  const double metallic = a.number({"metallic"}, 0);
  const Vec3d base = a.colour({"baseColor"}, 1);
  const Vec3d normal = in_unit(a.colour({"specularColor"}, 1) * root * root) * a.number({"specular"}, 1);
  const double roughness = a.number({"roughness"}, 0.5);
  const double across = std::max(1e-4, roughness * roughness);
  const double anisotropy = a.number({"anisotropy"}, 0);
  const double along = across + (1 - across) * anisotropy * anisotropy;
  return {base * (1 - metallic), base * metallic + normal * (1 - metallic), 2 / (along * across) - 2};
}

// Coats, fibres and films are lost.
BrdfLobes openpbr(const Arguments& a) {
  const double ior = a.number({"ior", "specular_ior"}, 1.5);
  const double root = (ior - 1) / (ior + 1);
  const double weight = a.number({"specularWeight", "specular_weight"}, 1);
  const double metalness = a.number({"metalness", "base_metalness"}, 0);
  const Vec3d base = a.colour({"baseColor", "base_color"}, 0.8) * a.number({"baseWeight", "base_weight"}, 1);
  const Vec3d dielectric =
      a.colour({"specularColor", "specular_color"}, 1) * std::min(1.0, weight * root * root);
  const double roughness = a.number({"roughness", "specular_roughness"}, 0.3);
  const double less = 1 - a.number({"anisotropy", "specular_roughness_anisotropy"}, 0);
  const double along = std::max(1e-4, roughness * roughness) * std::sqrt(2 / (1 + less * less));
  return {base * (1 - metalness), base * (metalness * std::min(1.0, weight)) + dielectric * (1 - metalness),
          2 / (along * std::max(1e-4, along * less)) - 2};
}

constexpr std::array<BrdfRule, 30> BrdfRules = {{
    {"diffuse", "kd", "", "", [](const Arguments& a) { return diffuse(a.colour({"kd"}, 0.5)); }},
    {"minnaert", "kd", "", "", [](const Arguments& a) { return diffuse(a.colour({"kd"}, 0.5)); }},
    {"oren", "r", "", "", [](const Arguments& a) { return diffuse(a.colour({"r"}, 0.5)); }},
    {"specular", "", "ks", "infinite",
     [](const Arguments& a) {
       return BrdfLobes{Vec3d(0), a.colour({"ks"}, 1), Mirror};
     }},
    {"glass", "", "((ior - 1)/(ior + 1))^2", "infinite",
     [](const Arguments& a) {
       return BrdfLobes{Vec3d(0), Vec3d(a.fresnel(1.5)), Mirror};
     }},
    {"coupled", "Rm (1 - R0)", "R0", "infinite", coupled},
    {"lewis", "kd", "ks", "4 n", lewis},
    {"phong", "kd", "ks 2 pi/(n + 2), as its lobe is not normalised", "4 n", phong},
    {"blinn", "kd", "ks 8 pi (n + 2^(-n/2))/((n + 2) (n + 4)), for the same reason", "n", blinn},
    {"lafortune", "kp", "Cz^n 2 pi/(n + 2)", "4 n", lafortune},
    {"ward", "kd", "ks", "2/(sx sy) - 2", ward},
    {"torrance", "kd", "ks F", "2/rough^2 - 2", torrance},
    {"ashikhmin", "Rd (1 - Rs)", "Rs", "sqrt(ex ey)", ashikhmin},
    {"schlick", "with Ly: DC (1 - SC)", "SC", "2/Sr - 2", schlick},
    {"strauss", "kd (1 - m s) (1 - s^3)", "ks s^3, tinted by kd in proportion to m", "12/(1 - s)", strauss},
    {"neumann", "kd", "ks", "16/(r ry) - 8", neumann},
    {"beardmaxwell", "Rd + Rv", "Rs F", "2/sigma^2 - 2", beardmaxwell},
    {"kajiya", "kd", "ks F", "taux tauy/(2 sigma^2) - 2", kajiya},
    {"hanrahan", "(kd + the single scattering part of albedo) (1 - F)^2", "ks F", "2/rough^2 - 2", hanrahan},
    {"westin", "kd", "ks F", "tau^2/(2 sigma^2) - 2", wave},
    {"he", "kd", "ks F", "tau^2/(2 sigma^2) - 2", wave},
    {"granier", "kd", "ks F + kt (1 - F)^2", "m/nreal^2, or n if ks F is the larger", granier},
    {"poulin", "kd", "ks", "n", poulin},
    {"eon", "kd m/(1 - kd (1 - m)), m the albedo of white facets in single scattering", "", "", eon},
    {"ggx", "", "ks F0, or ks F", "2/(ax ay) - 2", ggx},
    {"gltf", "(1 - metallic) baseColor", "metallic baseColor + (1 - metallic) F0", "2/(ax ay) - 2", gltf},
    {"openpbr", "(1 - metalness) baseWeight baseColor",
     "specularWeight (metalness baseWeight baseColor + (1 - metalness) specularColor F0)", "2/(ax ay) - 2",
     openpbr},
    {"thinfilm", "", "ks F, F at 610, 550 and 465 nm", "2/(ax ay) - 2", thinfilm},
    {"coat", "", "((ior - 1)/(ior + 1))^2", "2/alpha^2 - 2",
     [](const Arguments& a) {
       return BrdfLobes{Vec3d(0), Vec3d(a.fresnel(1.5)), exponent_of(a.number({"alpha"}, 0.1))};
     }},
    {"sheen", "ks R, R the mean albedo of the fibres", "", "", sheen},
}};

}  // namespace

double slope_of(double exponent) { return std::sqrt(2 / (std::max(exponent, 0.0) + 2)); }

double exponent_of(double slope) { return slope > 0 ? 2 / (slope * slope) - 2 : Mirror; }

BrdfLobes brdf_lobes(const grf::BrdfModel& brdf) {
  const auto* rule = std::find_if(BrdfRules.begin(), BrdfRules.end(), [&](const BrdfRule& candidate) {
    return grf::same_keyword(candidate.keyword, brdf.keyword);
  });
  if (rule == BrdfRules.end()) return Unknown;
  const BrdfLobes lobes = rule->lobes(Arguments(brdf));
  const double exponent = std::isnan(lobes.exponent) ? 0 : std::max(lobes.exponent, 0.0);
  return {in_unit(lobes.diffuse), in_unit(lobes.glossy), exponent};
}

BrdfLobes layered_lobes(const grf::BrdfModel& brdf, std::span<const BrdfLobes> layers) {
  if (layers.empty()) return Unknown;
  const bool is_coat = layers.size() == 1;
  const BrdfLobes top = is_coat ? brdf_lobes(brdf) : layers[1];
  Vec3d below = Vec3d(1) - in_unit(top.diffuse + top.glossy);
  if (is_coat) below *= Arguments(brdf).colour({"tint"}, 1);
  const BrdfLobes base = {layers[0].diffuse * below, layers[0].glossy * below, layers[0].exponent};
  return sum_of_lobes(std::array<WeightedLobes, 2>{{{1, top}, {1, base}}});
}

BrdfLobes sum_of_lobes(std::span<const WeightedLobes> terms) {
  BrdfLobes total;
  double strongest = 0;
  for (const auto& [weight, lobes] : terms) {
    const Vec3d glossy = lobes.glossy * weight;
    total.diffuse += lobes.diffuse * weight;
    total.glossy += glossy;
    if (strength(glossy) <= strongest) continue;
    strongest = strength(glossy);
    total.exponent = lobes.exponent;
  }
  return {in_unit(total.diffuse), in_unit(total.glossy), total.exponent};
}

namespace {

/// Returns the lobes of a layered BRDF. `check` bounds the number of layers.
BrdfLobes lobes_of_layers(const grf::BrdfModel& brdf, const grf::Scope& scope) {
  std::vector<BrdfLobes> layers;
  for (std::size_t i = 0; i < brdf.terms.size(); ++i) {
    const grf::WeightedBrdf named = grf::named_term(brdf, i, scope);
    layers.push_back(named.model != nullptr ? brdf_lobes(*named.model, named.scope) : Unknown);
  }
  return layered_lobes(brdf, layers);
}

}  // namespace

BrdfLobes brdf_lobes(const grf::BrdfModel& brdf, const grf::Scope& scope) {
  if (brdf.terms.empty()) return brdf_lobes(brdf);
  if (is_layered(brdf)) return lobes_of_layers(brdf, scope);
  std::vector<WeightedLobes> terms;
  for (const grf::WeightedBrdf& summand : grf::summands_of(brdf, scope)) {
    const BrdfLobes lobes = is_layered(*summand.model) ? lobes_of_layers(*summand.model, summand.scope)
                                                       : brdf_lobes(*summand.model);
    terms.push_back({static_cast<double>(summand.weight), lobes});
  }
  return sum_of_lobes(terms);
}

std::span<const BrdfRule> brdf_rules() { return BrdfRules; }

}  // namespace convert
