// How materials of other formats become GRF's: the one place that decides it (FORMATS.md shows the table).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "converters/losses.h"
#include "grf/math.h"
#include "grf/scene.h"
#include "grf/visit.h"

namespace convert {

/// What a material of the Phong family reflects beside its diffuse part.
enum class Reflection {
  None,    ///< nothing, whatever its specular reflectance is
  Glossy,  ///< a lobe about the mirror direction
  Mirror,  ///< a mirror image; where an exponent is given, only if that is of a mirror's sharpness
};

/// A material of the Phong family, such as those of MTL files. Values are kept in double so that 1 - 0.9,
/// once rounded to float, is written 0.1.
struct PhongMaterial {
  std::string name;
  grf::Vec3d diffuse = grf::Vec3d(0.5);  ///< GRF's default
  grf::Vec3d specular = grf::Vec3d(0);
  grf::Vec3d emission = grf::Vec3d(0);  ///< radiance, W/(sr m2)
  std::optional<double> exponent;
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

/// What a BRDF reflects as facets over a matte part. Facets reflect `specular` at normal incidence.
struct FacetValues {
  grf::Vec3d diffuse = grf::Vec3d(0);
  grf::Vec3d specular = grf::Vec3d(0);
  double slope = 1;
};

/// The nearest values of a BRDF; the terms of a `combine` are looked up in the scope. What is known of no
/// model, and data files, count as GRF's default.
FacetValues facet_values(const grf::BrdfModel& brdf, const grf::Scope& scope);

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
