#pragma once

#include "renderer/plot/svg.h"
#include "samples/studies/sampling/measure.h"

namespace study {

/// The error over the number of Sobol points, under the environment map, of some of the BRDFs.
plot::Svg convergence_chart(const Results& results);

/// The error with 256 Sobol points: a row for each BRDF and a mark for each scheme, under each light.
plot::Svg scheme_chart(const Results& results);

}  // namespace study
