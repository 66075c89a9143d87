// GRF's BRDFs are decomposed into lobes for other formats by one table: it says which parameters of which
// model are the diffuse and glossy reflectance and the lobe width. Both families of materials use it.
#pragma once

#include <span>
#include <string_view>

#include "grf/math.h"
#include "grf/model.h"
#include "grf/visit.h"

namespace convert {

/// A BRDF as a diffuse and a glossy lobe.
struct BrdfLobes {
  grf::Vec3d diffuse = grf::Vec3d(0);  ///< albedo of the diffuse lobe at normal incidence, 0 to 1
  grf::Vec3d glossy = grf::Vec3d(0);   ///< albedo of the glossy lobe at normal incidence, 0 to 1
  /// The Blinn-Phong exponent, of the cosine between normal and half vector, of about the same lobe width;
  /// infinite for perfect specular reflection. The Phong exponent, about the mirror direction, is a quarter
  /// of it, since the half vector turns half as fast.
  double exponent = 0;
};

/// Returns the lobes of a BRDF that is no `combine`, by the table below. Measured data and unknown models
/// count as GRF's default, diffuse grey.
BrdfLobes brdf_lobes(const grf::BrdfModel& brdf);

/// One term of a weighted sum of BRDFs.
struct WeightedLobes {
  double weight = 1;
  BrdfLobes lobes;
};

/// Returns the lobes of a layered BRDF, given those of its base and, for a `layer`, its top. The base gets
/// what the layer above does not reflect at normal incidence, and what a coat does not absorb.
BrdfLobes layered_lobes(const grf::BrdfModel& brdf, std::span<const BrdfLobes> layers);

/// Returns the lobes of a weighted sum, with the exponent of the strongest glossy lobe.
BrdfLobes sum_of_lobes(std::span<const WeightedLobes> terms);

/// Returns the lobes of any BRDF; the terms of a `combine` are looked up in the scope.
BrdfLobes brdf_lobes(const grf::BrdfModel& brdf, const grf::Scope& scope);

/// Converts a Blinn-Phong exponent to the RMS slope of a Beckmann distribution, and back: n = 2/slope^2 - 2.
double slope_of(double exponent);
double exponent_of(double slope);

class BrdfArguments;

/// The decomposition of one model. The texts document the function, in the model's parameters.
struct BrdfRule {
  std::string_view keyword;
  std::string_view diffuse;
  std::string_view glossy;
  std::string_view exponent;
  BrdfLobes (*lobes)(const BrdfArguments& arguments);
};

std::span<const BrdfRule> brdf_rules();  ///< Returns the rules of all models that can be decomposed.

}  // namespace convert
