// The mapping between GRF and microfacets over a diffuse base, in both directions: the table of FORMATS.md.
#include <algorithm>
#include <cmath>

#include "converters/mapping_helpers.h"
#include "converters/material_mapping.h"

namespace convert {
namespace {

/// The smallest slope of `torrance`.
constexpr double SmallestSlope = 1e-4;
/// The largest exponent of `ashikhmin`.
constexpr double HighestExponent = 1e6;
/// The largest R0 of `coupled`.
constexpr double LargestPolish = 0.999;

double largest(const grf::Vec3d& v) { return std::max({v.x, v.y, v.z}); }

grf::BrdfModel brdf_of(const grf::Vec3d& diffuse, const grf::Vec3d& specular, double slope, bool is_metal) {
  if (specular == grf::Vec3d(0)) return make_brdf("diffuse", {{"kd", to_value(diffuse)}});
  if (is_metal && slope < SmallestSlope) return make_brdf("specular", {{"ks", to_value(specular)}});
  if (is_metal) {
    // An index of refraction with Fresnel reflectance 1, so that ks is the metal's colour at every angle.
    return make_brdf("torrance", {{"rough", static_cast<float>(slope)},
                                  {"nreal", 1.0F},
                                  {"nimag", 100.0F},
                                  {"ks", to_value(specular)},
                                  {"kd", 0.0F}});
  }
  const double exponent = exponent_of(slope);
  if (exponent > HighestExponent) {
    const grf::Vec3d polish(std::min(specular.x, LargestPolish), std::min(specular.y, LargestPolish),
                            std::min(specular.z, LargestPolish));
    return make_brdf("coupled", {{"Rm", to_value(diffuse)}, {"R0", to_value(polish)}});
  }
  return make_brdf("ashikhmin", {{"ex", static_cast<float>(std::max(exponent, 0.0))},
                                 {"Rs", to_value(specular)},
                                 {"Rd", to_value(diffuse)}});
}

grf::Vec3d inside(const grf::Vec3d& v) {
  const auto clamp = [](double x) { return std::isfinite(x) ? std::clamp(x, 0.0, 1.0) : 0.0; };
  return {clamp(v.x), clamp(v.y), clamp(v.z)};
}

}  // namespace

MappedMaterial map_material(const MicrofacetMaterial& material) {
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

// The diffuse lobe of `parts` is attenuated by the microfacets, so that it is divided by their transmittance.
MicrofacetValues microfacet_values(const BrdfLobes& lobes) {
  MicrofacetValues values = {grf::Vec3d(0), lobes.glossy, slope_of(lobes.exponent)};
  for (int i = 0; i < 3; ++i) {
    const double through = 1 - lobes.glossy[i];
    values.diffuse[i] = through > 0 ? std::min(lobes.diffuse[i] / through, 1.0) : 0;
  }
  return values;
}

// Specular reflectance of a dielectric gives metallic = 0; more needs metal, whose fraction solves
// base colour = diffuse/(1 - metallic) = (specular - 0.04 (1 - metallic))/metallic for the brightest channel.
MetallicRoughness metallic_roughness(const MicrofacetValues& values) {
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

MicrofacetValues microfacet_values(const MetallicRoughness& material, const grf::Vec3d& dielectric) {
  const double m = material.metallic;
  return {material.base_colour * (1 - m), dielectric * (1 - m) + material.base_colour * m,
          material.roughness * material.roughness};
}

}  // namespace convert
