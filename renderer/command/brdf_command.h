// `bpt brdf`: what there is to know of a BRDF without a scene.
#pragma once

#include <optional>
#include <string>

#include "grf/exit_code.h"

namespace command {

struct BrdfArguments {
  std::string instance;  ///< `ward sx=0.2`, or the name of a file that holds one
  std::string view;      ///< `theta,phi` in radians; phi may be left out
  std::string light;     ///< the same
  std::string output;
  bool json = false;
};

/// All models with their parameters.
grf::ExitCode list_brdfs(const BrdfArguments& arguments);

/// Values in 1/sr for the pair of directions, or for each line `theta_u phi_u theta_v phi_v` of standard
/// input.
grf::ExitCode evaluate_brdf(const BrdfArguments& arguments);

/// The albedo for a view direction.
grf::ExitCode print_albedo(const BrdfArguments& arguments);

/// A picture of the BRDF: polar and cartesian in the plane of incidence, albedo, a lit sphere.
grf::ExitCode plot_brdf(const BrdfArguments& arguments);

/// A file of the MERL data base with the BRDF's values, and how far those between the cells are from the
/// BRDF's own.
grf::ExitCode export_brdf(const BrdfArguments& arguments);

}  // namespace command
