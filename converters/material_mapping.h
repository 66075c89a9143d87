// How materials of other formats become GRF's: the one place that decides it (FORMATS.md shows the tables).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "converters/brdf_parts.h"
#include "converters/losses.h"
#include "grf/math.h"
#include "grf/scene.h"

namespace convert {

/// What a material of the Phong family reflects beside its diffuse part.
enum class Reflection {
  None,    ///< nothing, whatever its specular reflectance is
  Glossy,  ///< a lobe about the mirror direction
  Mirror,  ///< a mirror image; where an exponent is given, only if that is of a mirror's sharpness
};

/// The exponent of a lobe about the mirror direction, max(0, u.r)^n, that is about as wide as one of the
/// cosine between normal and half vector: the half vector turns half as fast.
constexpr double about_mirror(double half_vector_exponent) { return half_vector_exponent / 4; }

/// A material of the Phong family, such as those of MTL files. Values are kept in double so that 1 - 0.9,
/// once rounded to float, is written 0.1.
struct PhongMaterial {
  std::string name;
  grf::Vec3d diffuse = grf::Vec3d(0.5);  ///< GRF's default
  grf::Vec3d specular = grf::Vec3d(0);
  grf::Vec3d emission = grf::Vec3d(0);  ///< radiance, W/(sr m2)
  std::optional<double> exponent;       ///< about the mirror direction
  std::optional<grf::Texture> diffuse_map;
  Reflection reflection = Reflection::Glossy;

  std::string_view source;                 ///< the name of the format
  std::vector<std::string> source_values;  ///< what the file says of the material, word for word
  std::vector<Loss> losses;                ///< what a face with this material loses
  grf::SourceLocation location;
};

/// A material of the kind that glTF has: facets, of which each reflects after Fresnel, over a matte part.
/// Light that the facets reflect does not reach the matte part.
struct FacetMaterial {
  std::string name;
  grf::Vec3d diffuse = grf::Vec3d(1);      ///< albedo of the matte part
  grf::Vec3d specular = grf::Vec3d(0.04);  ///< reflectance of a facet at normal incidence
  double slope = 1;                        ///< roughness: the RMS slope of the facets, 0 to 1
  bool is_metal = false;                   ///< it has no matte part
  grf::Vec3d emission = grf::Vec3d(0);     ///< radiance, W/(sr m2)
  std::optional<grf::Texture> map;         ///< multiplies all of it

  std::string_view source;                 ///< the name of the format
  std::vector<std::string> source_values;  ///< what the file says of the material
  std::vector<Loss> losses;                ///< what a face with this material loses
  grf::SourceLocation location;
};

/// A material as a scene has it: a definition for faces to refer to, and what only faces can have.
struct MappedMaterial {
  grf::Definition definition;
  std::optional<grf::Colour> colour;  ///< multiplies the BRDF
  std::optional<grf::Colour> emission;
  std::optional<grf::Texture> texture;  ///< multiplies the BRDF's colours
  std::vector<Loss> losses;
  bool clamped = false;  ///< a value was out of its range
};

/// The nearest BRDF under the material's own name, with the original values in a comment.
MappedMaterial map_material(const PhongMaterial& material);
MappedMaterial map_material(const FacetMaterial& material);

/// A material of which nothing but the name is known.
MappedMaterial unknown_material(const std::string& name, const grf::BrdfModel& brdf);

/// What faces reflect of which nothing is known: GRF's default, written out.
grf::BrdfModel default_brdf();

// The way back, for formats that have such materials.

/// The material of the Phong family with these parts: the inverse of `map_material` for the BRDFs that it
/// gives. Name, emission and image are left as they are by default.
PhongMaterial phong_material(const BrdfParts& parts);

/// What facets over a matte part are: `diffuse` is the albedo that the matte part would have without them.
struct FacetValues {
  grf::Vec3d diffuse = grf::Vec3d(0);
  grf::Vec3d specular = grf::Vec3d(0);  ///< at normal incidence
  double slope = 1;
};

/// The facets with these parts: the inverse of `map_material` too, but for the index of its metals.
FacetValues facet_values(const BrdfParts& parts);

/// The parameters of glTF's metallic-roughness materials, each 0 to 1.
struct MetallicRoughness {
  grf::Vec3d base_colour = grf::Vec3d(1);
  double metallic = 1;
  double roughness = 1;  ///< the root of the slope
};

MetallicRoughness metallic_roughness(const FacetValues& values);
/// `dielectric` is what facets that are no metal reflect at normal incidence.
FacetValues facet_values(const MetallicRoughness& material, const grf::Vec3d& dielectric = grf::Vec3d(0.04));

}  // namespace convert
