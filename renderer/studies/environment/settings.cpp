#include "renderer/studies/environment/settings.h"

#include <cmath>

#include "renderer/studies/angles.h"

namespace studies {

using reflectance::Vec3f;

namespace {

reflectance::Parameter<EnvironmentSettings> show_parameter() {
  return reflectance::word_parameter(
      &EnvironmentSettings::show, "show", {"map", "fcos", "light", "warps", "product", "scheme", "lost"},
      "the map itself; or a density: in proportion to f cos, of the map's own sampling, of that for this "
      "normal, in proportion to f cos L, or of the candidates; or where candidates are too few: product over "
      "candidates");
}

}  // namespace

reflectance::Resampling EnvironmentSettings::counts() const {
  return {static_cast<int>(std::lround(candidates)), static_cast<int>(std::lround(samples))};
}

Visibility EnvironmentSettings::visible_directions() const {
  constexpr double Square = 30 * Degree;
  switch (visibility) {
    case 1:
      return [](const Vec3f& v) {
        const double squares = std::floor(std::atan2(double(v.y), double(v.x)) / Square) +
                               std::floor(std::asin(double(v.z)) / Square);
        return std::fmod(std::abs(squares), 2.0) < 1;
      };
    case 2:
      return [](const Vec3f& v) { return v.x >= 0; };
    default:
      return [](const Vec3f&) { return true; };
  }
}

reflectance::ModelTable<EnvironmentSettings> EnvironmentSettings::table() {
  using Self = EnvironmentSettings;
  using grf::ParameterScale;
  using reflectance::boolean_parameter;
  using reflectance::in_unit;
  using reflectance::number_parameter;
  using reflectance::whole;
  using reflectance::word_parameter;
  return {
      .keyword = "emviewer",
      .title = "EM viewer",
      .paper = "Talbot et al. 2005",
      .parameters =
          {in_unit("deg", number_parameter(&Self::theta, "theta", 0, 89.9F, "view angle, from the normal")),
           in_unit("deg", number_parameter(&Self::phi, "phi", -180, 180,
                                           "view azimuth, from the tangent; of a surface that faces y the "
                                           "tangent is x, and 90 is towards the map's centre, -z")),
           in_unit("deg", number_parameter(&Self::tilt, "tilt", 0, 180,
                                           "angle of the surface's normal from y, which is up")),
           in_unit("deg", number_parameter(&Self::heading, "heading", -180, 180,
                                           "azimuth of the normal, from x towards -z")),
           whole(number_parameter(&Self::candidates, "N", 1, 16384,
                                  "number of candidates, from the scheme; BPT_RIS calls it M",
                                  ParameterScale::Logarithmic)),
           whole(number_parameter(
               &Self::samples, "M", 1, 16384,
               "number of samples that are chosen from the candidates, N at most; BPT_RIS calls it N",
               ParameterScale::Logarithmic)),
           whole(number_parameter(&Self::seed, "seed", 0, 65535, "seed of the random numbers")),
           show_parameter(),
           word_parameter(&Self::channel, "channel", {"colour", "luminance"},
                          "the map in its colours, or its luminance in false colours"),
           word_parameter(&Self::dots, "dots", {"both", "candidates", "samples", "hidden"},
                          "which directions are drawn as dots"),
           in_unit("stops", number_parameter(&Self::exposure, "exposure", -16, 16,
                                             "exposure of the map in its colours")),
           in_unit("deg", number_parameter(&Self::azimuth, "azimuth", -180, 180,
                                           "azimuth of the side from which the sphere is seen, from x "
                                           "towards -z")),
           in_unit("deg", number_parameter(&Self::elevation, "elevation", -89, 89,
                                           "elevation of the side from which the sphere is seen")),
           boolean_parameter(&Self::deviations, "deviations",
                             "measure how much estimates deviate, over 64 repetitions or more for each N"),
           word_parameter(&Self::visibility, "visibility", {"open", "checker", "half"},
                          "what is hidden from the samples in the measurement of deviations: nothing, "
                          "every other square of 30 degrees, or the half of the directions with x < 0")},
      .description =
          "Shows how samples of the product of a BRDF and an environment map are chosen from candidates of "
          "the BRDF's sampling scheme, and how good they are."};
}

}  // namespace studies
