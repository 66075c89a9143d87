#pragma once

#include "grf/math.h"
#include "renderer/transport/lights/environment_map.h"
#include "renderer/transport/lights/lights.h"

namespace transport {

/// The probability with which light sampling should pick the environment map and not an emitter: the map's
/// share of the power that comes in. The map's is what it sends through the disc of the sphere about the
/// bounds, as if nothing were in its way; since walls may be, or lamps may be shut in, neither goes below
/// 1/5. 1 without emitters, 0 if the map is black or null. Any value in between keeps an estimate unbiased.
float environment_share(const EnvironmentMap* environment, const Lights& lights, const grf::Box3d& bounds);

}  // namespace transport
