// `bpt brdf`: what there is to know of a BRDF without a scene.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "grf/exit_code.h"

namespace command {

struct BrdfArguments {
  std::string instance;  ///< `ward sx=0.2`, or the name of a file that holds one
  std::string view;      ///< `theta,phi` in radians; phi may be left out
  std::string light;     ///< the same
  std::string output;
  std::string pdf;                 ///< a sampling scheme, `hemisphere exp=20`
  std::vector<std::string> views;  ///< for `plot`: `theta,phi` each; empty: some that tell much
  std::uint32_t count = 1000;      ///< samples to draw
  std::uint32_t seed = 0;
  std::string fit;  ///< a FIT file to write
  bool json = false;
};

/// All models with their parameters.
grf::ExitCode list_brdfs(const BrdfArguments& arguments);

/// Values in 1/sr for the pair of directions, or for each line `theta_u phi_u theta_v phi_v` of standard
/// input.
grf::ExitCode evaluate_brdf(const BrdfArguments& arguments);

/// The albedo for a view direction.
grf::ExitCode print_albedo(const BrdfArguments& arguments);

/// Directions that a scheme draws, with their densities and the BRDF's values; also as a FIT file.
grf::ExitCode sample_brdf(const BrdfArguments& arguments);

/// A picture of the BRDF: polar and cartesian in the plane of incidence, albedo, a lit sphere. With a
/// sampling scheme, one of what that draws.
grf::ExitCode plot_brdf(const BrdfArguments& arguments);

/// A file of the MERL data base with the BRDF's values, and how far those between the cells are from the
/// BRDF's own.
grf::ExitCode export_brdf(const BrdfArguments& arguments);

}  // namespace command
