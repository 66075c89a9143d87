// Charts that correspond to the thesis' figures.
#pragma once

#include <string>

#include "renderer/plot/svg.h"
#include "samples/studies/thesis/printed.h"
#include "samples/studies/thesis/results.h"

namespace study {

/// Charts error over time: the thesis' (over its sampling times), and today's per integrator (total time).
plot::Svg time_error_chart(const Results& results, const std::string& scene, const PrintedTable& times,
                           const PrintedTable& errors);

/// Charts figure 5.11: a Lewis BRDF and the pdfs of cosine lobes.
plot::Svg lobe_chart();

}  // namespace study
