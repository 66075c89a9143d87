#include "converters/nearest_phong.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <map>
#include <numbers>
#include <string_view>

#include "grf/keywords.h"

namespace convert {
namespace {

using grf::Vec3d;

/// The exponent of a mirror, as MTL files have it.
constexpr double MirrorExponent = 1000;
constexpr double HighestExponent = 1e6;

/// The values of an instance, with the defaults of its model (renderer/MODELS.md) where there is none.
class Values {
 public:
  explicit Values(const grf::Model& model) : model_(model) {}

  double number(std::initializer_list<std::string_view> names, double otherwise) const {
    const grf::Value* value = find(names);
    const float* number = value == nullptr ? nullptr : std::get_if<float>(value);
    return number == nullptr ? otherwise : static_cast<double>(*number);
  }
  Vec3d colour(std::initializer_list<std::string_view> names, double otherwise) const {
    const grf::Value* value = find(names);
    if (value == nullptr) return Vec3d(otherwise);
    if (const auto* colour = std::get_if<grf::Colour>(value)) return Vec3d(*colour);
    const auto* number = std::get_if<float>(value);
    return Vec3d(number == nullptr ? otherwise : static_cast<double>(*number));
  }
  bool flag(std::string_view name) const {
    const grf::Value* value = find({name});
    if (value == nullptr) return false;
    if (const auto* flag = std::get_if<bool>(value)) return *flag;
    const auto* number = std::get_if<float>(value);
    return number != nullptr && *number != 0;
  }

 private:
  const grf::Value* find(std::initializer_list<std::string_view> names) const {
    for (const grf::Argument& argument : model_.arguments) {
      const auto is_called = [&](std::string_view name) { return grf::same_keyword(argument.name, name); };
      if (std::any_of(names.begin(), names.end(), is_called)) return &argument.value;
    }
    return nullptr;
  }

  const grf::Model& model_;
};

PhongMaterial matte(const Vec3d& diffuse) {
  PhongMaterial material;
  material.diffuse = diffuse;
  material.reflection = Reflection::None;
  return material;
}

PhongMaterial glossy(const Vec3d& diffuse, const Vec3d& specular, double exponent) {
  PhongMaterial material;
  material.diffuse = diffuse;
  material.specular = specular;
  material.exponent = std::clamp(exponent, 0.0, HighestExponent);
  return material;
}

PhongMaterial mirror(const Vec3d& diffuse, const Vec3d& specular) {
  PhongMaterial material = glossy(diffuse, specular, MirrorExponent);
  material.reflection = Reflection::Mirror;
  return material;
}

// The half vector turns half as fast as the mirror direction: cos(delta)^n is about as wide as
// cos(2 delta)^(n/4).
double exponent_of_half(double exponent) { return exponent / 4; }

// Near the normal, exp(-tan(delta)^2/slope^2) is cos(delta)^(2/slope^2).
double exponent_of_slope(double slope) { return exponent_of_half(2 / std::max(slope * slope, 1e-9)); }

/// Fresnel's reflectance at normal incidence; an index of 0 is a perfect conductor.
double fresnel(double real, double imaginary) {
  if (real == 0 && imaginary == 0) return 1;
  const double square = imaginary * imaginary;
  return ((real - 1) * (real - 1) + square) / ((real + 1) * (real + 1) + square);
}

/// The albedo at normal incidence of max(0, u.r)^n.
double albedo_of_power(double n) { return 2 * std::numbers::pi / (n + 2); }
/// The same of cos(delta)^n with the half vector.
double albedo_of_half_power(double n) {
  return 8 * std::numbers::pi * (n + std::exp2(-n / 2)) / ((n + 2) * (n + 4));
}

struct Rule {
  std::string_view keyword;
  PhongMaterial (*apply)(const Values& v);
};

constexpr std::array<Rule, 21> Rules = {{
    {"specular", [](const Values& v) { return mirror(Vec3d(0), v.colour({"ks"}, 1)); }},
    {"diffuse", [](const Values& v) { return matte(v.colour({"kd"}, 0.5)); }},
    {"phong",
     [](const Values& v) {
       const double n = v.number({"n"}, 100);
       return glossy(v.colour({"kd"}, 0.6), v.colour({"ks"}, 0.4) * albedo_of_power(n), n);
     }},
    {"blinn",
     [](const Values& v) {
       const double n = v.number({"n"}, 100);
       return glossy(v.colour({"kd"}, 0.6), v.colour({"ks"}, 0.4) * albedo_of_half_power(n),
                     exponent_of_half(n));
     }},
    {"lewis",
     [](const Values& v) {
       return glossy(v.colour({"kd"}, 0.6), v.colour({"ks"}, 0.4), v.number({"n"}, 100));
     }},
    {"ward",
     [](const Values& v) {
       const double sx = v.number({"sx"}, 0.2);
       const double slope = std::sqrt(sx * v.number({"sy"}, sx));
       return glossy(v.colour({"kd"}, 0.5), v.colour({"ks"}, 0.5), exponent_of_slope(slope));
     }},
    {"minnaert", [](const Values& v) { return matte(v.colour({"kd"}, 0.5)); }},
    {"lafortune",
     [](const Values& v) {
       const double n = v.number({"n"}, 20);
       const double height = std::pow(std::max(v.number({"Cz"}, 1), 0.0), n);
       return glossy(v.colour({"kp", "kd"}, 0.5), Vec3d(height * albedo_of_power(n)), n);
     }},
    {"oren", [](const Values& v) { return matte(v.colour({"r"}, 0.5)); }},
    {"torrance",
     [](const Values& v) {
       const double facet = fresnel(v.number({"nreal"}, 1.5), v.number({"nimag"}, 0));
       return glossy(v.colour({"kd"}, 0.3), v.colour({"ks"}, 0.7) * facet,
                     exponent_of_slope(v.number({"rough", "m"}, 0.35)));
     }},
    {"coupled",
     [](const Values& v) {
       const Vec3d polish = v.colour({"R0", "Ro"}, 0.05);
       return mirror(v.colour({"Rm"}, 0.5) * (Vec3d(1) - polish), polish);
     }},
    {"ashikhmin",
     [](const Values& v) {
       const double ex = v.number({"ex", "nu"}, 25);
       const Vec3d facet = v.colour({"Rs", "ks"}, 0.39);
       return glossy(v.colour({"Rd", "kd"}, 0.6) * (Vec3d(1) - facet), facet,
                     exponent_of_half(std::sqrt(ex * v.number({"ey", "nv"}, ex))));
     }},
    {"schlick",
     [](const Values& v) {
       const Vec3d outer = v.colour({"SC"}, 0.7);
       const Vec3d under = v.flag("Ly") ? v.colour({"DC"}, 0.5) * (Vec3d(1) - outer) : Vec3d(0);
       const double rough = v.number({"Sr"}, 0.31);
       return rough == 0 ? mirror(under, outer) : glossy(under, outer, exponent_of_slope(std::sqrt(rough)));
     }},
    {"strauss",
     [](const Values& v) {
       const double s = v.number({"s"}, 0.5);
       const double m = v.number({"m"}, 0);
       const Vec3d kd = v.colour({"kd"}, 0.5);
       const double most = std::max({kd.x, kd.y, kd.z});
       const Vec3d tint = most > 0 ? Vec3d(1) + (kd / most - Vec3d(1)) * m : Vec3d(1);
       const double smooth = s * s * s;
       return glossy(kd * ((1 - m * s) * (1 - smooth)), v.colour({"ks"}, 0.5) * tint * smooth,
                     3 / std::max(1 - s, 3e-5));
     }},
    {"neumann",
     [](const Values& v) {
       // The mean of sin^2 is r^2/2 over the disc, and 2/(n + 2) over the lobe.
       const double r = v.number({"r"}, 0.2);
       return glossy(v.colour({"kd"}, 0), v.colour({"ks"}, 1), 4 / (r * v.number({"ry"}, r)) - 2);
     }},
    {"beardmaxwell",
     [](const Values& v) {
       const double facet = fresnel(v.number({"nreal"}, 1.65), v.number({"nimag"}, 0));
       return glossy(v.colour({"Rd"}, 0.3) + v.colour({"Rv"}, 0.1), v.colour({"Rs"}, 1) * facet,
                     exponent_of_slope(v.number({"sigma"}, 0.3)));
     }},
    {"kajiya",
     [](const Values& v) {
       const double facet = fresnel(v.number({"nreal"}, 0), v.number({"nimag"}, 0));
       const double length = std::sqrt(v.number({"taux"}, 1) * v.number({"tauy"}, 4));
       return glossy(v.colour({"kd"}, 0), v.colour({"ks"}, 1) * facet,
                     exponent_of_slope(2 * v.number({"sigma"}, 0.2) / length));
     }},
    {"hanrahan",
     [](const Values& v) {
       const double facet = fresnel(v.number({"nreal"}, 1.4), 0);
       constexpr double OnceScattered = 0.3;  // of a deep layer, where all of its albedo were 1
       const double share = std::min(v.number({"depth"}, 10), 1.0) * OnceScattered;
       return glossy((v.colour({"kd"}, 0.2) + v.colour({"albedo"}, 0.8) * share) * (1 - facet),
                     v.colour({"ks"}, 1) * facet, exponent_of_slope(v.number({"rough"}, 0.3)));
     }},
    {"granier",
     [](const Values& v) {
       const Vec3d n = v.colour({"nreal"}, 1.51);
       const Vec3d facet(fresnel(n.x, 0), fresnel(n.y, 0), fresnel(n.z, 0));
       return glossy(v.colour({"kd"}, 0) + v.colour({"kt"}, 0.8) * (Vec3d(1) - facet),
                     v.colour({"ks"}, 1) * facet, exponent_of_half(v.number({"n"}, 100)));
     }},
    {"poulin",
     [](const Values& v) {
       return glossy(v.colour({"kd"}, 0.5), v.colour({"ks"}, 0.5), exponent_of_half(v.number({"n"}, 50)));
     }},
    {"he",
     [](const Values& v) {
       const double facet = fresnel(v.number({"nreal"}, 0), v.number({"nimag"}, 0));
       return glossy(v.colour({"kd"}, 0), v.colour({"ks"}, 1) * facet,
                     exponent_of_slope(2 * v.number({"sigma"}, 0.2) / v.number({"tau"}, 2)));
     }},
}};

/// Each BRDF once, since sums of sums may share terms.
class Nearest {
 public:
  explicit Nearest(const FindTerm& find_term) : find_term_(find_term) {}

  PhongMaterial of(const grf::BrdfModel& brdf, int depth) {
    constexpr int Deepest = 100;
    if (!brdf.terms.empty()) return depth < Deepest ? sum(brdf, depth) : matte(Vec3d(0.5));
    const std::string_view keyword = grf::same_keyword(brdf.keyword, "westin") ? "he" : brdf.keyword;
    const auto* rule = std::find_if(Rules.begin(), Rules.end(), [keyword](const Rule& candidate) {
      return grf::same_keyword(candidate.keyword, keyword);
    });
    // Of measured data, and of models that nobody knows, there is nothing to go by.
    return rule == Rules.end() ? matte(Vec3d(0.5)) : rule->apply(Values(brdf));
  }

 private:
  /// The weighted sum of materials, with the lobe of the one that reflects most by its own.
  PhongMaterial sum(const grf::BrdfModel& brdf, int depth) {
    PhongMaterial total = matte(Vec3d(0));
    double strongest = 0;
    for (const grf::CombineTerm& term : brdf.terms) {
      const grf::BrdfModel* found = find_term_(term);
      if (found == nullptr) continue;
      if (!known_.contains(found)) known_.emplace(found, of(*found, depth + 1));
      const PhongMaterial& part = known_.at(found);
      total.diffuse += part.diffuse * term.weight;
      const Vec3d specular = part.specular * term.weight;
      total.specular += specular;
      const double strength = specular.x + specular.y + specular.z;
      if (strength <= strongest) continue;
      strongest = strength;
      total.exponent = part.exponent;
      total.reflection = part.reflection;
    }
    return total;
  }

  const FindTerm& find_term_;
  std::map<const grf::BrdfModel*, PhongMaterial> known_;
};

/// Components that a material can have.
Vec3d clamped(const Vec3d& v) {
  return {std::clamp(v.x, 0.0, 1.0), std::clamp(v.y, 0.0, 1.0), std::clamp(v.z, 0.0, 1.0)};
}

}  // namespace

PhongMaterial nearest_phong(const grf::BrdfModel& brdf, const FindTerm& find_term) {
  PhongMaterial material = Nearest(find_term).of(brdf, 0);
  material.diffuse = clamped(material.diffuse);
  material.specular = clamped(material.specular);
  return material;
}

}  // namespace convert
