#pragma once

#include <string>
#include <vector>

#include "renderer/command/brdf_instance.h"
#include "renderer/command/directions.h"
#include "renderer/plot/svg.h"

namespace command {

/// How a scheme samples a BRDF, a row for each view: on the unit disc the scheme's density with samples of it
/// and, in the same colours, f cos over the albedo, which a perfect scheme has for density; both in the plane
/// of incidence; the distribution of the weights. And what the scheme's tables cost. Without views, for three
/// polar angles.
plot::Svg picture_of_sampling(const SampledInstance& instance, const std::string& brdf,
                              const std::string& pdf, const std::vector<Angles>& views);

}  // namespace command
