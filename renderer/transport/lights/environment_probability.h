#pragma once

#include "grf/math.h"
#include "renderer/transport/lights/environment_map.h"
#include "renderer/transport/lights/lights.h"

namespace transport {

/// Returns the probability of sampling the environment map rather than an emitter: the map's fraction of the
/// incoming power. The map's power is what it sends through the disc of the bounding sphere, unoccluded;
/// since walls may block it, or lamps may be enclosed, both probabilities are at least 1/5. 1 without
/// emitters, 0 if the map is black or null. Any value in between keeps an estimate unbiased.
float environment_probability(const EnvironmentMap* environment, const Lights& lights,
                              const grf::Box3d& bounds);

}  // namespace transport
