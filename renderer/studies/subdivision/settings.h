#pragma once

#include <cmath>
#include <cstdint>

#include "renderer/reflectance/model.h"
#include "renderer/studies/drawn_samples.h"

namespace studies {

struct SubdivisionSettings {
  enum Pattern { Sobol, Independent };
  enum Panels { One, Compare };
  enum ColouredBy { Value, Mass, Acceptance, ChiSquare };

  float theta = 45;
  float phi = 0;
  float nmax = 2;
  float depth = 8;
  float resolution = 200;
  float count = 2500;
  float seed = 0;
  int pattern = Sobol;
  int coloured_by = Value;
  int panels = One;
  float sample = 0;
  float step = 12;
  float azimuth = 60;
  float elevation = 25;

  /// Draws so many samples of a reflector as these settings say.
  DrawnSamples drawn(const reflectance::Reflector& reflector, const reflectance::Vec3f& u) const {
    return draw_samples(
        reflector, u, static_cast<std::uint32_t>(std::lround(count)),
        static_cast<std::uint32_t>(std::lround(seed)),
        pattern == Sobol ? transport::SamplePattern::Sobol : transport::SamplePattern::Independent);
  }

  static reflectance::ModelTable<SubdivisionSettings> table() {
    using Self = SubdivisionSettings;
    using grf::ParameterScale;
    using reflectance::in_unit;
    using reflectance::number_parameter;
    using reflectance::whole;
    using reflectance::word_parameter;
    return {
        .keyword = "subdivision",
        .title = "Adaptive subdivision",
        .paper = "Montes, Urena, Garcia and Lastra 2008",
        .parameters =
            {in_unit("deg",
                     number_parameter(&Self::theta, "theta", 0, 89, "angle of the view to the normal")),
             in_unit("deg", number_parameter(&Self::phi, "phi", -180, 180, "azimuth of the view")),
             number_parameter(&Self::nmax, "nmax", 1.01F, 100,
                              "of the tree shown: mean number of tries above which a cell is split",
                              ParameterScale::Logarithmic),
             whole(number_parameter(&Self::depth, "depth", 0, 10,
                                    "of the tree shown: cells at this depth are not split")),
             whole(number_parameter(&Self::resolution, "res", 2, 800,
                                    "of the tree shown: grid resolution, in cells per edge; 'adaptive' "
                                    "uses 800, and takes longer",
                                    ParameterScale::Logarithmic)),
             whole(number_parameter(&Self::count, "count", 0, 20000, "number of samples")),
             whole(number_parameter(&Self::seed, "seed", 0, 1e6F, "random seed of the samples")),
             word_parameter(&Self::pattern, "pattern", {"sobol", "independent"},
                            "the random numbers: Sobol' points, as in the path tracer, or independent ones, "
                            "for p-values that are uniform in [0,1]"),
             word_parameter(&Self::coloured_by, "colour", {"value", "mass", "acceptance", "chisquare"},
                            "what the colours of the cells mean: f, the cell's share of the samples, the "
                            "share of tries accepted, or counts against expectations"),
             word_parameter(&Self::panels, "panels", {"one", "compare"},
                            "the tree with the lobe, or six sampling schemes side by side"),
             whole(number_parameter(&Self::sample, "sample", 0, 20000,
                                    "the sample whose way down the tree is shown; 0: none")),
             whole(number_parameter(&Self::step, "step", 0, 12, "levels shown of that way")),
             in_unit("deg", number_parameter(&Self::azimuth, "azimuth", -180, 180,
                                             "azimuth of the eye, from the x axis")),
             in_unit("deg", number_parameter(&Self::elevation, "elevation", 0, 89,
                                             "elevation of the eye over the surface"))},
        .description =
            "Shows the adaptive quadtree of a BRDF on the unit disc of directions, which 'adaptive "
            "mode=reject' samples, and the samples of a scheme or of a FIT file in its cells."};
  }
};

}  // namespace studies
