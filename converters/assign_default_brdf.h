#pragma once

#include "grf/scene.h"

namespace convert {

/// Assigns the BRDF to all faces that have none and emit no light, in included files too.
void assign_default_brdf(grf::Scene& scene, const grf::BrdfModel& brdf);

}  // namespace convert
