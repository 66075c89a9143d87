// `bpt brdf` evaluates, samples, checks, plots and exports a BRDF without a scene.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "grf/exit_code.h"

namespace command {

struct BrdfArguments {
  std::string instance;            ///< see reflectance::read_instance
  std::string view;                ///< view direction, `theta,phi` in radians; phi may be left out
  std::string light;               ///< light direction, likewise
  std::vector<float> wavelengths;  ///< for `eval`, in nanometres; empty: those of the BRDF, if it has any
  std::string output;
  std::string pdf;                 ///< a sampling scheme, `hemisphere exp=20`
  std::vector<std::string> views;  ///< for `plot`: `theta,phi` each; empty: 0, 45 and 80 degrees
  std::uint32_t count = 1000;      ///< samples to draw
  std::uint32_t seed = 0;
  std::string reader;  ///< of an exported RGL file: `pbrt`, `mitsuba`, `mitsuba-spectral`, or empty
  std::optional<double> resolution = 1;  ///< of an exported RGL file; empty: as fine as `largest_error` needs
  double largest_error = 0.02;           ///< mean interpolation error as a fraction of the mean value
  std::string fit;                       ///< path of the FIT file to write; empty: none
  bool json = false;
};

/// Lists all BRDF models with their parameters.
grf::ExitCode list_brdfs(const BrdfArguments& arguments);

/// Evaluates the BRDF, in 1/sr, for one pair of directions, or for each line `theta_u phi_u theta_v phi_v` of
/// standard input: in RGB and, if the model or data have them, at wavelengths.
grf::ExitCode evaluate_brdf(const BrdfArguments& arguments);

/// Prints the directional albedo for a view direction.
grf::ExitCode print_albedo(const BrdfArguments& arguments);

/// Samples directions by a sampling scheme; prints their pdfs and BRDF values, and can write a FIT file.
grf::ExitCode sample_brdf(const BrdfArguments& arguments);

/// Prints the BRDF as GLSL 3.30 without `#version`, which defines `vec3 brdf_value(vec3 u, vec3 v)`, f in
/// 1/sr; as JSON, also the values of its `uniform vec3 brdf_parameters[]`. Measured data have none.
grf::ExitCode print_glsl(const BrdfArguments& arguments);

/// Plots the BRDF: polar and cartesian in the plane of incidence, albedo, a lit sphere. With a sampling
/// scheme, plots its pdf and samples instead.
grf::ExitCode plot_brdf(const BrdfArguments& arguments);

/// Tabulates the BRDF as a file of the MERL or, if the output's name ends in `.bsdf`, of the RGL data base,
/// and reports the largest and mean interpolation error against the BRDF itself.
grf::ExitCode export_brdf(const BrdfArguments& arguments);

/// Prints whether the BRDF is reciprocal, conserves energy, and has data without holes and negative values,
/// and draws where not if an output is named.
grf::ExitCode check_brdf(const BrdfArguments& arguments);

}  // namespace command
