// Materials of other formats are converted to GRF's by these rules alone (FORMATS.md shows the tables).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "converters/brdf_lobes.h"
#include "converters/gltf/gltf_brdf.h"
#include "converters/losses.h"
#include "grf/math.h"
#include "grf/scene.h"

namespace convert {

/// The specular reflection of a material of the Phong family.
enum class Reflection {
  None,    ///< no specular reflection, whatever the specular reflectance is
  Glossy,  ///< a glossy lobe about the mirror direction
  Mirror,  ///< perfect specular reflection; if there is an exponent, only if it is high enough for a mirror
};

/// Converts a Blinn-Phong exponent to the Phong exponent, max(0, u.r)^n, of about the same lobe width: the
/// half vector turns half as fast.
constexpr double to_phong_exponent(double half_vector_exponent) { return half_vector_exponent / 4; }
constexpr double to_half_vector_exponent(double phong_exponent) { return phong_exponent * 4; }

/// A material of the Phong family, such as those of MTL files, or one with physically based parameters that a
/// file of that family gives beside them. Values are kept in double so that 1 - 0.9, once rounded to float,
/// is written 0.1.
struct PhongMaterial {
  std::string name;
  grf::Vec3d diffuse = grf::Vec3d(0.5);  ///< GRF's default
  grf::Vec3d specular = grf::Vec3d(0);
  grf::Vec3d emission = grf::Vec3d(0);  ///< radiance, W/(sr m2)
  double opacity = 1;                   ///< a factor of the alpha of the map if that is read
  bool reads_alpha = false;             ///< of the diffuse map
  std::optional<double> exponent;       ///< Phong exponent, about the mirror direction
  std::optional<grf::Texture> diffuse_map;
  Reflection reflection = Reflection::Glossy;
  /// Metallic, roughness and so on, which then replace the highlight; the base colour is `diffuse`.
  std::optional<GltfBrdf> physically_based;

  std::string_view source;                 ///< the name of the format
  std::vector<std::string> source_values;  ///< the original values of the file, verbatim
  std::vector<Loss> losses;                ///< losses of a face with this material
  grf::SourceLocation location;
};

/// A material converted to GRF: a BRDF definition that faces refer to, and the attributes of those faces.
struct MappedMaterial {
  grf::Definition definition;
  std::optional<grf::Colour> colour;  ///< multiplies the BRDF
  std::optional<grf::Colour> emission;
  std::optional<grf::Opacity> opacity;
  std::optional<grf::Texture> texture;  ///< multiplies the BRDF's colours
  std::vector<Loss> losses;
  bool clamped = false;  ///< a value was out of its range
};

/// Maps a material to the nearest BRDF, under its own name and with the original values in a comment.
MappedMaterial map_material(const PhongMaterial& material);

/// Makes a material of which only the name is known.
MappedMaterial unknown_material(const std::string& name, const grf::BrdfModel& brdf);

/// Returns GRF's default BRDF, `diffuse kd=0.5`, for faces without a known material.
grf::BrdfModel default_brdf();

/// Returns the Phong material with these lobes: the inverse of `map_material` for the BRDFs that it gives.
/// Name, emission and image have their defaults.
PhongMaterial phong_material(const BrdfLobes& lobes);

}  // namespace convert
