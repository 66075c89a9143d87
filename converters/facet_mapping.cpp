// Facets over a matte part, in both directions: the table of FORMATS.md.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "converters/mapping_parts.h"
#include "converters/material_mapping.h"
#include "grf/keywords.h"

namespace convert {
namespace {

/// The smallest that `torrance` has.
constexpr double SmallestSlope = 1e-4;
/// The largest that `ashikhmin` has.
constexpr double HighestExponent = 1e6;
/// The largest R0 that `coupled` has.
constexpr double LargestPolish = 0.999;
/// Of no metal, and of no combination with one.
constexpr int DeepestCombination = 16;

double largest(const grf::Vec3d& v) { return std::max({v.x, v.y, v.z}); }

// Beckmann's facets and those of Blinn's lobe cos^n have the same width for slope^2 = 2/(n+2).
double exponent_of(double slope) { return 2 / (slope * slope) - 2; }
double slope_of(double exponent) { return std::sqrt(2 / (std::max(exponent, 0.0) + 2)); }

grf::BrdfModel brdf_of(const grf::Vec3d& diffuse, const grf::Vec3d& specular, double slope, bool is_metal) {
  if (specular == grf::Vec3d(0)) return make_brdf("diffuse", {{"kd", to_value(diffuse)}});
  if (is_metal && slope < SmallestSlope) return make_brdf("specular", {{"ks", to_value(specular)}});
  if (is_metal) {
    // An index of refraction whose facets reflect all, so that ks is the metal's colour at every angle.
    return make_brdf("torrance", {{"rough", static_cast<float>(slope)},
                                  {"nreal", 1.0F},
                                  {"nimag", 100.0F},
                                  {"ks", to_value(specular)},
                                  {"kd", 0.0F}});
  }
  const double exponent = slope > 0 ? exponent_of(slope) : 2 * HighestExponent;
  if (exponent > HighestExponent) {
    const grf::Vec3d polish(std::min(specular.x, LargestPolish), std::min(specular.y, LargestPolish),
                            std::min(specular.z, LargestPolish));
    return make_brdf("coupled", {{"Rm", to_value(diffuse)}, {"R0", to_value(polish)}});
  }
  return make_brdf("ashikhmin", {{"ex", static_cast<float>(std::max(exponent, 0.0))},
                                 {"Rs", to_value(specular)},
                                 {"Rd", to_value(diffuse)}});
}

// GRF -> facets.

/// The arguments of a model, with the defaults and aliases of MODELS.md, which a test compares.
class Arguments {
 public:
  explicit Arguments(const grf::BrdfModel& brdf) : brdf_(brdf) {}

  grf::Vec3d colour(std::string_view name, std::string_view alias, double otherwise) const {
    const grf::Value* value = find(name, alias);
    if (value == nullptr) return grf::Vec3d(otherwise);
    if (const auto* rgb = std::get_if<grf::Colour>(value)) return grf::Vec3d(*rgb);
    const auto* number = std::get_if<float>(value);
    return grf::Vec3d(number != nullptr ? *number : otherwise);
  }
  grf::Vec3d colour(std::string_view name, double otherwise) const { return colour(name, {}, otherwise); }
  double number(std::string_view name, std::string_view alias, double otherwise) const {
    const auto* value = find(name, alias);
    const auto* number = value == nullptr ? nullptr : std::get_if<float>(value);
    return number == nullptr ? otherwise : *number;
  }
  double number(std::string_view name, double otherwise) const { return number(name, {}, otherwise); }
  bool flag(std::string_view name) const {
    const auto* value = find(name, {});
    const auto* flag = value == nullptr ? nullptr : std::get_if<bool>(value);
    return flag != nullptr && *flag;
  }
  /// Reflectance at normal incidence of facets with an index of refraction; 0 is a perfect conductor.
  double fresnel(double default_real, double default_imaginary = 0) const {
    const double n = number("nreal", default_real);
    const double k = number("nimag", default_imaginary);
    if (n == 0) return 1;
    return ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k);
  }

 private:
  const grf::Value* find(std::string_view name, std::string_view alias) const {
    for (const grf::Argument& argument : brdf_.arguments) {
      if (grf::same_keyword(argument.name, name) || grf::same_keyword(argument.name, alias)) {
        return &argument.value;
      }
    }
    return nullptr;
  }

  const grf::BrdfModel& brdf_;
};

double mean(double a, double b) { return std::sqrt(std::max(a, 0.0) * std::max(b, 0.0)); }

struct Row {
  std::string_view keyword;
  FacetValues (*values)(const Arguments&);
};

FacetValues strauss(const Arguments& a) {
  const double smooth = a.number("s", 0.5);
  const grf::Vec3d colour = a.colour("kd", 0.5);
  const double metal = a.number("m", 0);
  return {colour * (1 - metal * smooth) * (1 - smooth * smooth * smooth),
          (grf::Vec3d(0.04) * (1 - metal) + colour * metal) * a.colour("ks", 0.5),
          (1 - smooth) * (1 - smooth)};
}

FacetValues ward(const Arguments& a) {
  const double sx = a.number("sx", 0.2);
  return {a.colour("kd", 0.5), a.colour("ks", 0.5), mean(sx, a.number("sy", sx))};
}

FacetValues ashikhmin(const Arguments& a) {
  const double ex = a.number("ex", "nu", 25);
  return {a.colour("Rd", "kd", 0.6), a.colour("Rs", "ks", 0.39),
          slope_of(mean(ex, a.number("ey", "nv", ex)))};
}

FacetValues schlick(const Arguments& a) {
  const grf::Vec3d below = a.flag("Ly") ? a.colour("DC", 0.5) : grf::Vec3d(0);
  return {below, a.colour("SC", 0.7), a.number("Sr", 0.31)};
}

// A lobe about the mirror direction is as wide as one about the half vector with four times the exponent.
FacetValues lewis(const Arguments& a) {
  return {a.colour("kd", 0.6), a.colour("ks", 0.4), slope_of(4 * a.number("n", 100))};
}

// The lobe is not normalised: this is what it reflects at the normal.
FacetValues phong(const Arguments& a) {
  const double n = a.number("n", 100);
  return {a.colour("kd", 0.6), a.colour("ks", 0.4) * (2 * std::numbers::pi / (n + 2)), slope_of(4 * n)};
}

FacetValues blinn(const Arguments& a) {
  const double n = a.number("n", 100);
  const double share = 8 * std::numbers::pi * (n + std::exp2(-n / 2)) / ((n + 2) * (n + 4));
  return {a.colour("kd", 0.6), a.colour("ks", 0.4) * share, slope_of(n)};
}

FacetValues lafortune(const Arguments& a) {
  const double n = a.number("n", 20);
  const double share = 2 * std::numbers::pi * std::pow(std::max(a.number("Cz", 1), 0.0), n) / (n + 2);
  return {a.colour("kp", "kd", 0.5), grf::Vec3d(share), slope_of(4 * n)};
}

FacetValues wave(const Arguments& a) {
  const double slope = 2 * a.number("sigma", 0.2) / a.number("tau", 2);
  return {a.colour("kd", 0), a.colour("ks", 1) * a.fresnel(0), slope};
}

FacetValues kajiya(const Arguments& a) {
  const double width = mean(a.number("taux", 1), a.number("tauy", 4));
  return {a.colour("kd", 0), a.colour("ks", 1) * a.fresnel(0), 2 * a.number("sigma", 0.2) / width};
}

FacetValues hanrahan(const Arguments& a) {
  // What a half space reflects of light from the normal by one isotropic scattering.
  constexpr double ScatteredOnce = (1 - std::numbers::ln2) / 2;
  return {a.colour("kd", 0.2) + a.colour("albedo", 0.8) * ScatteredOnce, a.colour("ks", 1) * a.fresnel(1.4),
          a.number("rough", 0.3)};
}

FacetValues granier(const Arguments& a) {
  const double n = a.colour("nreal", 1.51).y;
  const double polish = (n - 1) * (n - 1) / ((n + 1) * (n + 1));
  return {a.colour("kd", 0), a.colour("ks", 1) * polish + a.colour("kt", 0.8) * (1 - polish),
          slope_of(a.number("n", 100))};
}

FacetValues poulin(const Arguments& a) {
  return {a.colour("kd", 0.5), a.colour("ks", 0.5), slope_of(a.number("n", 50))};
}

constexpr std::array<Row, 23> Rows = {{
    {"specular",
     [](const Arguments& a) {
       return FacetValues{grf::Vec3d(0), a.colour("ks", 1), 0};
     }},
    {"diffuse",
     [](const Arguments& a) {
       return FacetValues{a.colour("kd", 0.5), grf::Vec3d(0), 1};
     }},
    {"minnaert",
     [](const Arguments& a) {
       return FacetValues{a.colour("kd", 0.5), grf::Vec3d(0), 1};
     }},
    {"oren",
     [](const Arguments& a) {
       return FacetValues{a.colour("r", 0.5), grf::Vec3d(0), 1};
     }},
    {"coupled",
     [](const Arguments& a) {
       return FacetValues{a.colour("Rm", 0.5), a.colour("R0", "Ro", 0.05), 0};
     }},
    {"torrance",
     [](const Arguments& a) {
       return FacetValues{a.colour("kd", 0.3), a.colour("ks", 0.7) * a.fresnel(1.5),
                          a.number("rough", "m", 0.35)};
     }},
    {"neumann",
     [](const Arguments& a) {
       const double r = a.number("r", 0.2);
       return FacetValues{a.colour("kd", 0), a.colour("ks", 1), mean(r, a.number("ry", r)) / 2};
     }},
    {"beardmaxwell",
     [](const Arguments& a) {
       return FacetValues{a.colour("Rd", 0.3) + a.colour("Rv", 0.1), a.colour("Rs", 1) * a.fresnel(1.65),
                          a.number("sigma", 0.3)};
     }},
    {"phong", phong},
    {"blinn", blinn},
    {"lewis", lewis},
    {"ward", ward},
    {"lafortune", lafortune},
    {"ashikhmin", ashikhmin},
    {"schlick", schlick},
    {"strauss", strauss},
    {"kajiya", kajiya},
    {"hanrahan", hanrahan},
    {"westin", wave},
    {"he", wave},
    {"granier", granier},
    {"poulin", poulin},
    {"measured",
     [](const Arguments&) {
       return FacetValues{grf::Vec3d(0.5), grf::Vec3d(0), 1};
     }},
}};

grf::Vec3d inside(const grf::Vec3d& v) {
  const auto clamp = [](double x) { return std::isfinite(x) ? std::clamp(x, 0.0, 1.0) : 0.0; };
  return {clamp(v.x), clamp(v.y), clamp(v.z)};
}

FacetValues limited(FacetValues values) {
  values.diffuse = inside(values.diffuse);
  values.specular = inside(values.specular);
  values.slope = inside(grf::Vec3d(values.slope)).x;
  return values;
}

FacetValues values_of(const grf::BrdfModel& brdf, const grf::Scope& scope, int depth);

// Slopes count by what their facets reflect.
FacetValues sum_of(const std::vector<grf::CombineTerm>& terms, const grf::Scope& scope, int depth) {
  FacetValues sum;
  double slopes = 0;
  double weights = 0;
  for (const grf::CombineTerm& term : terms) {
    const auto* brdf = scope.find<grf::BrdfModel>(term.brdf.name);
    if (brdf == nullptr) continue;
    const FacetValues part = values_of(*brdf, scope.around(term.brdf.name), depth + 1);
    sum.diffuse += part.diffuse * term.weight;
    sum.specular += part.specular * term.weight;
    slopes += part.slope * term.weight * largest(part.specular);
    weights += term.weight * largest(part.specular);
  }
  if (weights > 0) sum.slope = slopes / weights;
  return limited(sum);
}

FacetValues values_of(const grf::BrdfModel& brdf, const grf::Scope& scope, int depth) {
  if (!brdf.terms.empty() && depth < DeepestCombination) return sum_of(brdf.terms, scope, depth);
  const auto* row = std::find_if(Rows.begin(), Rows.end(), [&](const Row& candidate) {
    return grf::same_keyword(candidate.keyword, brdf.keyword);
  });
  if (row == Rows.end()) return {grf::Vec3d(0.5), grf::Vec3d(0), 1};
  return limited(row->values(Arguments(brdf)));
}

}  // namespace

MappedMaterial map_material(const FacetMaterial& material) {
  MappedMaterial mapped = named_material(material.name, material.source, material.source_values);
  mapped.definition.location = material.location;
  mapped.losses = material.losses;
  mapped.texture = material.map;
  const grf::Vec3d diffuse = clamped(material.diffuse, 1, mapped);
  const grf::Vec3d specular = clamped(material.specular, 1, mapped);
  mapped.definition.body = brdf_of(diffuse, specular, clamped(material.slope, 1, mapped), material.is_metal);
  finish(material.emission, mapped);
  return mapped;
}

FacetValues facet_values(const grf::BrdfModel& brdf, const grf::Scope& scope) {
  return values_of(brdf, scope, 0);
}

// What the facets of a dielectric reflect is left to metallic = 0; what is over it needs metal, whose share
// solves base colour = diffuse/(1 - metallic) = (specular - 0.04 (1 - metallic))/metallic for the brightest
// channel.
MetallicRoughness metallic_roughness(const FacetValues& values) {
  constexpr double Dielectric = 0.04;
  const double d = largest(values.diffuse);
  const double s = largest(values.specular);
  MetallicRoughness material;
  material.roughness = std::sqrt(values.slope);
  material.metallic = 0;
  if (s > Dielectric) {
    const double b = d + s - 2 * Dielectric;
    const double root = std::sqrt(std::max(b * b - 4 * Dielectric * (Dielectric - s), 0.0));
    material.metallic = std::clamp((root - b) / (2 * Dielectric), 0.0, 1.0);
  } else if (s == 0) {
    material.roughness = 1;
  }
  const double m = material.metallic;
  const grf::Vec3d of_diffuse = m < 1 ? values.diffuse / (1 - m) : grf::Vec3d(0);
  const grf::Vec3d of_specular =
      m > 0 ? (values.specular - grf::Vec3d(Dielectric * (1 - m))) / m : grf::Vec3d(0);
  material.base_colour = inside(of_diffuse * (1 - m) + of_specular * m);
  return material;
}

FacetValues facet_values(const MetallicRoughness& material, const grf::Vec3d& dielectric) {
  const double m = material.metallic;
  return {material.base_colour * (1 - m), dielectric * (1 - m) + material.base_colour * m,
          material.roughness * material.roughness};
}

}  // namespace convert
