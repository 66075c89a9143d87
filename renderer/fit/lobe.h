// A lobe is a BRDF model of a fit, alone or as a term of a sum, with its free parameters.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "grf/catalogue.h"
#include "renderer/fit/observations.h"
#include "renderer/reflectance/brdf.h"

namespace fit {

/// A parameter that changes the shape of a lobe. A fit moves its coordinate t from 0 to 1, which is
/// logarithmic over wide ranges.
struct ShapeParameter {
  std::string name;
  std::optional<int> channel;  ///< the channel of a colour that it is; else all channels have the value
  double minimum = 0;
  double maximum = 1;
  bool is_logarithmic = false;
  double usual = 0.5;  ///< the coordinate of the model's default

  /// Returns the value at a coordinate, which is a float, as in a BRDF.
  double value(double t) const;
  double coordinate(double value) const;
  /// Maps uniform numbers to coordinates of a scan: half of them are uniform, and half are around the
  /// default, within a factor of ten where the range is logarithmic, and within a quarter of it where it is
  /// linear.
  double scanned(double uniform) const;
};

/// A colour that enters the model linearly, such as `kd`: its unknowns are solved by linear least squares.
struct ColourParameter {
  std::string name;
  double maximum = 1;
};

struct Lobe {
  grf::ModelInfo info;
  std::vector<grf::Argument> fixed;  ///< parameters with values that the fit keeps
  std::vector<ShapeParameter> shapes;
  std::vector<ColourParameter> colours;
  /// In a sum, the lobe has a weight of its own: it is not black where its linear colours are.
  bool has_weight = false;
  std::vector<std::string> held;  ///< names of parameters that keep their defaults, and why
};

/// Returns the instance of a lobe's model with values of its shapes and its linear colours.
grf::BrdfModel model_of(const Lobe& lobe, std::span<const double> shapes, std::span<const Vec3d> colours);

/// Returns the BRDF of that; nothing if the model does not take these values together.
std::optional<reflectance::Brdf> brdf_of(const Lobe& lobe, std::span<const double> shapes,
                                         std::span<const Vec3d> colours);

/// Finds the free parameters of the lobes of a target by evaluating their models for the directions of the
/// observations, so that no model need list what a fit does with its parameters:
/// - numbers are shapes, and so are colours that do not enter linearly, per channel if they are reflectances;
/// - booleans and words keep their defaults;
/// - what makes a model anisotropic is held for isotropic observations: the axis that follows another one,
///   and what has its default at an end of its range;
/// - a parameter is held whose smallest change from its default selects another formula (`F0` of `ggx`), or
///   that changes nothing here;
/// - of diffuse parts in a sum, one is free, and the others are 0.
/// Fixed arguments apply to the lobes that have such a parameter. Returns nothing after an error: an unknown
/// or unsuitable model, or one of which no parameter changes the values.
std::optional<std::vector<Lobe>> lobes_of(const std::vector<std::string>& keywords,
                                          const std::vector<grf::Argument>& fixed,
                                          const Observations& observations, grf::Diagnostics& diagnostics);

}  // namespace fit
