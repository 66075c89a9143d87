#pragma once

#include "renderer/plot/svg.h"
#include "samples/studies/sampling/measure.h"

namespace study {

/// Draws the error over the number of Sobol points, under the environment map, for some of the BRDFs.
plot::Svg convergence_chart(const Results& results);

/// Draws the error with 256 Sobol points, under each light: a row per BRDF and a mark per scheme.
plot::Svg scheme_chart(const Results& results);

}  // namespace study
