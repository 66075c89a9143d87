#pragma once

#include <string>
#include <vector>

#include "renderer/command/directions.h"
#include "renderer/plot/svg.h"
#include "renderer/reflectance/brdf_instance.h"

namespace command {

/// Plots how a scheme samples a BRDF, in one row per view: its pdf on the unit disc with samples and, in the
/// same colours, f cos / albedo, the pdf of perfect importance sampling; both in the plane of incidence; and
/// a histogram of the sample weights. The header has the cost of the scheme's tables. Without views, three
/// polar angles are shown.
plot::Svg picture_of_sampling(const reflectance::SampledInstance& instance, const std::string& brdf,
                              const std::string& pdf, const std::vector<Angles>& views);

}  // namespace command
