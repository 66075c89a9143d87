// The figures.
#pragma once

#include <string>

#include "renderer/plot/svg.h"
#include "samples/studies/thesis/printed.h"
#include "samples/studies/thesis/results.h"

namespace study {

/// Error over time: the thesis' (its sampling times), and today's by each integrator (all that it takes).
plot::Svg time_error_chart(const Results& results, const std::string& scene, const PrintedTable& times,
                           const PrintedTable& errors);

/// Figure 5.11: a BRDF of Lewis and lobes.
plot::Svg lobe_chart();

}  // namespace study
