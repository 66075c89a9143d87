#include "converters/gltf/gltf_brdf.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "converters/brdf_arguments.h"
#include "converters/mapping_helpers.h"

namespace convert {
namespace {

using grf::Vec3d;

/// A parameter of the BRDF. Numbers are handled as grey colours.
struct Parameter {
  std::string_view name;
  std::variant<double GltfBrdf::*, Vec3d GltfBrdf::*> member;
  double least = 0;
  double most = 1;
  std::string_view alias = name;

  Vec3d of(const GltfBrdf& values) const {
    return std::visit([&](auto field) { return Vec3d(values.*field); }, member);
  }
  void set(GltfBrdf& values, const Vec3d& value) const {
    if (const auto* number = std::get_if<double GltfBrdf::*>(&member)) {
      values.*(*number) = value.x;
    } else {
      values.*std::get<Vec3d GltfBrdf::*>(member) = value;
    }
  }
};

/// The table of renderer/reflectance/gltf.h, which a test compares.
constexpr std::array<Parameter, 15> Parameters = {{
    {.name = "baseColor", .member = &GltfBrdf::base},
    {.name = "metallic", .member = &GltfBrdf::metallic},
    {.name = "roughness", .member = &GltfBrdf::roughness},
    {.name = "ior", .member = &GltfBrdf::ior, .least = 1, .most = 10},
    {.name = "specular", .member = &GltfBrdf::specular},
    {.name = "specularColor", .member = &GltfBrdf::specular_colour, .most = 25},
    {.name = "anisotropy", .member = &GltfBrdf::anisotropy},
    {.name = "rotation", .member = &GltfBrdf::rotation, .least = -std::numbers::pi, .most = std::numbers::pi},
    {.name = "clearcoat", .member = &GltfBrdf::clearcoat},
    {.name = "coatRoughness", .member = &GltfBrdf::coat_roughness, .alias = "clearcoatRoughness"},
    {.name = "sheenColor", .member = &GltfBrdf::sheen_colour},
    {.name = "sheenRoughness", .member = &GltfBrdf::sheen_roughness, .least = 0.01},
    {.name = "iridescence", .member = &GltfBrdf::iridescence},
    {.name = "iridescenceIor", .member = &GltfBrdf::iridescence_ior, .least = 1, .most = 3},
    {.name = "filmThickness",
     .member = &GltfBrdf::film_thickness,
     .least = 10,
     .most = 1000,
     .alias = "iridescenceThicknessMaximum"},
}};

/// Returns whether a parameter, and with it its image, makes a difference.
bool has_effect(std::string_view parameter, const GltfBrdf& values) {
  const auto row = std::ranges::find(Parameters, parameter, &Parameter::name);
  if (row->of(values) == Vec3d(0)) return false;
  if (parameter == "coatRoughness") return values.clearcoat > 0;
  if (parameter == "sheenRoughness") return values.sheen_colour != Vec3d(0);
  if (parameter == "iridescenceIor" || parameter == "filmThickness") return values.iridescence > 0;
  return parameter != "rotation" || values.anisotropy != 0;
}

double largest(const Vec3d& v) { return std::max({v.x, v.y, v.z}); }
Vec3d absolute(const Vec3d& v) { return {std::abs(v.x), std::abs(v.y), std::abs(v.z)}; }

GltfBrdf values_of(const grf::BrdfModel& brdf) {
  GltfBrdf values;
  for (const Parameter& parameter : Parameters) {
    const double otherwise = parameter.of(values).x;
    const BrdfArguments arguments(brdf);
    parameter.set(values, arguments.colour({parameter.name, parameter.alias}, otherwise));
    if (const auto map = arguments.map({parameter.name, parameter.alias})) values.maps[parameter.name] = *map;
  }
  normalise(values);
  return values;
}

/// The least distance of glTF's attenuation that GRF has, and the largest.
constexpr double LeastDistance = 1e-6;
constexpr double LargestDistance = 1e6;
constexpr double LargestGlassIor = 4;

GltfBrdf values_of_glass(const grf::BrdfModel& brdf) {
  const BrdfArguments arguments(brdf);
  const Vec3d colour = arguments.colour({"colour", "color"}, 1);
  GltfBrdf values;
  values.roughness = 0;
  values.ior = arguments.number({"ior"}, values.ior);
  values.transmission = 1;
  if (arguments.flag("thin")) {
    values.base = colour;
  } else {
    values.thickness = 1;
    values.attenuation_colour = colour;
    if (colour != Vec3d(1)) values.attenuation_distance = arguments.number({"distance"}, 1);
  }
  normalise(values);
  return values;
}

grf::BrdfModel glass_of(const GltfBrdf& values) {
  std::vector<std::pair<std::string, grf::Value>> arguments;
  const double ior = std::min(values.ior, LargestGlassIor);
  if (ior != GltfBrdf().ior) arguments.emplace_back("ior", to_value(Vec3d(ior)));
  const bool is_solid = values.thickness > 0;
  const bool is_clear = is_solid && values.attenuation_distance > LargestDistance;
  const Vec3d colour = is_clear ? Vec3d(1) : is_solid ? values.attenuation_colour : values.base;
  if (colour != Vec3d(1)) arguments.emplace_back("colour", to_value(colour));
  if (is_solid && colour != Vec3d(1) && values.attenuation_distance != 1)
    arguments.emplace_back("distance", to_value(Vec3d(std::max(values.attenuation_distance, LeastDistance))));
  if (!is_solid) arguments.emplace_back("thin", true);
  return make_brdf("glass", arguments);
}

}  // namespace

bool normalise(GltfBrdf& values) {
  const GltfBrdf defaults;
  bool was_outside = false;
  for (const Parameter& parameter : Parameters) {
    const Vec3d value = parameter.of(values);
    Vec3d inside;
    for (int i = 0; i < 3; ++i) {
      inside[i] = std::isnan(value[i]) ? parameter.of(defaults)[i]
                                       : std::clamp(value[i], parameter.least, parameter.most);
    }
    was_outside = was_outside || inside != value;
    parameter.set(values, inside);
  }
  std::erase_if(values.maps, [&](const auto& map) { return !has_effect(map.first, values); });
  if (values.anisotropy == 0) values.rotation = defaults.rotation;
  if (values.clearcoat == 0) values.coat_roughness = defaults.coat_roughness;
  if (values.sheen_colour == Vec3d(0)) values.sheen_roughness = defaults.sheen_roughness;
  if (values.iridescence == 0) {
    values.iridescence_ior = defaults.iridescence_ior;
    values.film_thickness = defaults.film_thickness;
  }
  return was_outside;
}

GltfBrdf nearest_gltf(const grf::BrdfModel& brdf, const grf::Scope& scope) {
  if (brdf.terms.empty() && grf::same_keyword(brdf.keyword, "gltf")) return values_of(brdf);
  if (brdf.terms.empty() && grf::same_keyword(brdf.keyword, "glass")) return values_of_glass(brdf);
  return nearest_gltf(brdf_lobes(brdf, scope));
}

// A dielectric, whose facets let 0.96 through to its base, has metallic = 0. More specular reflectance needs
// metal, whose fraction m solves base (1 - m) = diffuse/0.96 and 0.04 (1 - m) + base m = glossy for the
// brightest channel.
GltfBrdf nearest_gltf(const BrdfLobes& lobes) {
  constexpr double Dielectric = 0.04;
  const double s = largest(lobes.glossy);
  GltfBrdf values;
  if (s == 0) {
    // Without this, diffuse materials would have a specular reflectance of 0.04.
    values.specular = 0;
    values.roughness = 1;
    values.base = lobes.diffuse;
    normalise(values);
    return values;
  }
  const Vec3d below = lobes.diffuse / (1 - Dielectric);
  values.roughness = std::sqrt(slope_of(lobes.exponent));
  if (s > Dielectric) {
    const double b = largest(below) + s - 2 * Dielectric;
    const double root = std::sqrt(std::max(b * b - 4 * Dielectric * (Dielectric - s), 0.0));
    values.metallic = std::clamp((root - b) / (2 * Dielectric), 0.0, 1.0);
  }
  const double m = values.metallic;
  values.base = m > 0 ? below + lobes.glossy - Vec3d(Dielectric * (1 - m)) : below;
  normalise(values);
  return values;
}

grf::BrdfModel to_brdf(const GltfBrdf& values) {
  if (values.is_glass()) return glass_of(values);
  const bool is_lambertian = values.metallic == 0 && values.specular == 0 && values.clearcoat == 0 &&
                             values.sheen_colour == Vec3d(0);
  if (is_lambertian) return make_brdf("diffuse", {{"kd", to_value(values.base)}});
  std::vector<std::pair<std::string, grf::Value>> arguments;
  for (const Parameter& parameter : Parameters) {
    const grf::Value value = to_value(parameter.of(values));
    const bool is_default = value == to_value(parameter.of(GltfBrdf()));
    if (!is_default || values.maps.contains(parameter.name)) arguments.emplace_back(parameter.name, value);
  }
  grf::BrdfModel brdf = make_brdf("gltf", arguments);
  for (grf::Argument& argument : brdf.arguments) {
    const auto map = values.maps.find(argument.name);
    if (map != values.maps.end()) argument.map = map->second;
  }
  return brdf;
}

bool is_nearly_equal(const GltfBrdf& a, const GltfBrdf& b) {
  constexpr double Rounding = 3e-6;
  const auto is_near = [](double x, double y) { return x == y || std::abs(x - y) <= Rounding * std::abs(x); };
  if (a.maps != b.maps || a.is_glass() != b.is_glass() || (a.thickness > 0) != (b.thickness > 0) ||
      !is_near(a.attenuation_distance, b.attenuation_distance) ||
      largest(absolute(a.attenuation_colour - b.attenuation_colour)) > Rounding)
    return false;
  return std::all_of(Parameters.begin(), Parameters.end(), [&](const Parameter& parameter) {
    const Vec3d difference = (parameter.of(a) - parameter.of(b)) / std::max(1.0, largest(parameter.of(a)));
    return std::max({std::abs(difference.x), std::abs(difference.y), std::abs(difference.z)}) < Rounding;
  });
}

}  // namespace convert
