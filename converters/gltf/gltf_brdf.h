// The BRDF `gltf` has the values of glTF's materials, so that this struct is between GRF and glTF files.
#pragma once

#include <limits>
#include <map>
#include <string_view>

#include "converters/brdf_lobes.h"
#include "grf/math.h"
#include "grf/model.h"
#include "grf/visit.h"

namespace convert {

/// The parameters of the BRDF `gltf`, with its defaults, which are not those of glTF files.
struct GltfBrdf {
  grf::Vec3d base = grf::Vec3d(1);
  double metallic = 0;
  double roughness = 0.5;
  double ior = 1.5;
  double specular = 1;
  grf::Vec3d specular_colour = grf::Vec3d(1);
  double anisotropy = 0;
  double rotation = 0;  ///< radians
  double clearcoat = 0;
  double coat_roughness = 0;
  grf::Vec3d sheen_colour = grf::Vec3d(0);
  double sheen_roughness = 0.3;
  double iridescence = 0;
  double iridescence_ior = 1.3;
  double film_thickness = 400;  ///< nanometres
  // A material that transmits most light is the BRDF `glass`, and `base` is then the colour of a pane.
  double transmission = 0;
  double thickness = 0;  ///< over 0: it bounds a solid
  grf::Vec3d attenuation_colour = grf::Vec3d(1);
  double attenuation_distance = std::numeric_limits<double>::infinity();
  /// Images that multiply parameters, by the parameter's name.
  std::map<std::string_view, grf::ParameterMap> maps = {};

  bool is_glass() const { return transmission > 0.5; }
};

/// Clamps values to the ranges of the BRDF, and resets those that have no effect, such as the roughness of a
/// coat that is not there, to their defaults, without their images. Returns whether a value was out of range.
bool normalise(GltfBrdf& values);

/// Returns the values of glTF's material for a BRDF: exact for `gltf` and `glass`, and else the nearest ones.
GltfBrdf nearest_gltf(const grf::BrdfModel& brdf, const grf::Scope& scope);
GltfBrdf nearest_gltf(const BrdfLobes& lobes);

/// Returns the BRDF of normalised values: `gltf` with those that are not its defaults, `glass`, or `diffuse`
/// if a dielectric without specular reflection makes it the same.
grf::BrdfModel to_brdf(const GltfBrdf& values);

/// Returns whether normalised values are equal but for the rounding of factors in files.
bool is_nearly_equal(const GltfBrdf& a, const GltfBrdf& b);

}  // namespace convert
