#pragma once

#include "renderer/command/cost_report.h"
#include "renderer/plot/svg.h"

namespace command {

/// Charts the error over render time, and over samples per pixel, as the thesis' figures 5.9 to 5.16.
plot::Svg cost_chart(const CostResult& result);

}  // namespace command
