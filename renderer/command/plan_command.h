#pragma once

#include <string>

#include "grf/exit_code.h"
#include "renderer/command/render_arguments.h"
#include "renderer/job/effect_measurement.h"

namespace command {

/// The command line of `bpt plan`; flags are those of `bpt render`.
struct PlanArguments {
  std::string scene;  ///< an OP file, or a GRF scene
  OptionFlags flags;
  bool json = false;
  bool measures = false;  ///< renders with and without each effect, see job::EffectMeasurement
  job::MeasurementSettings measurement;
  std::string images;            ///< a folder for the images that are rendered; empty: none
  std::string progress = "bar";  ///< `json`: prints an effect as one line as soon as it is measured
};

/// Prints which effects a render would use, which it would leave out, and why. Builds all tables of sampling
/// schemes to report their size, also those that a render would leave out; reads no image unless it measures.
grf::ExitCode plan(const PlanArguments& arguments);

}  // namespace command
