#pragma once

#include "grf/diagnostics.h"
#include "grf/exit_code.h"
#include "renderer/command/render_command.h"
#include "renderer/options/render_options.h"

namespace command {

/// Forecasts what a render will cost, and prints it: the time until each of some target errors, with the
/// interval that contains it with 90 % probability. It is extrapolated from a probe, which renders a sample
/// of the image's tiles in about `forecast_seconds`. Writes no file. `before` has the messages about the
/// options.
grf::ExitCode forecast(const RenderArguments& arguments, options::RenderOptions render_options,
                       const grf::Diagnostics& before);

}  // namespace command
