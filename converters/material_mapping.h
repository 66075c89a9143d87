// How materials of other formats become GRF's: the one place that decides it (FORMATS.md shows the table).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

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

/// A material as a scene has it: a definition for faces to refer to, and what only faces can have.
struct MappedMaterial {
  grf::Definition definition;
  std::optional<grf::Colour> emission;
  std::optional<grf::Texture> texture;  ///< multiplies the BRDF's colours
  std::vector<Loss> losses;
  bool clamped = false;  ///< a value was out of its range
};

/// The nearest BRDF under the material's own name, with the original values in a comment.
MappedMaterial map_material(const PhongMaterial& material);

/// A material of which nothing but the name is known.
MappedMaterial unknown_material(const std::string& name, const grf::BrdfModel& brdf);

/// What faces reflect of which nothing is known: GRF's default, written out.
grf::BrdfModel default_brdf();

}  // namespace convert
