#pragma once

#include "renderer/command/cost_report.h"
#include "renderer/plot/svg.h"

namespace command {

/// The error over the time, and over the samples: a line each, as the thesis' figures 5.9 to 5.16.
plot::Svg cost_chart(const CostResult& result);

}  // namespace command
