// What BRDFs of GRF are in the eyes of other formats: the one place that knows which parameters of which
// model are matte, glossy and wide. Both families of materials are made from it.
#pragma once

#include <span>
#include <string_view>

#include "grf/math.h"
#include "grf/model.h"
#include "grf/visit.h"

namespace convert {

/// A BRDF as a matte part and a highlight.
struct BrdfParts {
  grf::Vec3d matte = grf::Vec3d(0);   ///< what the matte part reflects of light from the normal, 0 to 1
  grf::Vec3d glossy = grf::Vec3d(0);  ///< the same of the highlight
  /// Of the cosine between normal and half vector, whose power is about as wide as the highlight; infinite of
  /// a mirror. About the mirror direction, a quarter of it is as wide, since the half vector turns half as
  /// fast.
  double exponent = 0;
};

/// The parts of a BRDF that is no `combine`, by the table below. Of measured data, and of models that nobody
/// knows, there is nothing to go by: they count as GRF's default, a matte grey.
BrdfParts brdf_parts(const grf::BrdfModel& brdf);

struct WeightedParts {
  double weight = 1;
  BrdfParts parts;
};

/// The parts of a sum, with the exponent of the strongest highlight.
BrdfParts sum_of_parts(std::span<const WeightedParts> terms);

/// Returns the parts of any BRDF; the terms of a `combine` are looked up in the scope.
BrdfParts brdf_parts(const grf::BrdfModel& brdf, const grf::Scope& scope);

/// The slope of Beckmann's facets that are as wide as the exponent, and back: n = 2/slope^2 - 2.
double slope_of(double exponent);
double exponent_of(double slope);

class BrdfArguments;

/// How one model is taken apart. The words say what the function does, in the model's parameters.
struct BrdfRule {
  std::string_view keyword;
  std::string_view matte;
  std::string_view glossy;
  std::string_view exponent;
  BrdfParts (*parts)(const BrdfArguments& arguments);
};

std::span<const BrdfRule> brdf_rules();

}  // namespace convert
