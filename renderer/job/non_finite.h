// Values that are not finite are searched for by rendering a scene.
#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>

#include "grf/diagnostics.h"
#include "grf/math.h"
#include "renderer/job/preview_scene.h"
#include "renderer/transport/integrators/kernel.h"

namespace job {

/// Describes which term was not finite, on which BRDF and where in the world.
std::string cause_text(const transport::NotFinite& cause, const transport::CompiledScene& scene);

struct NonFiniteSearch {
  std::uint64_t samples = 0;        ///< that were rendered
  std::uint64_t rejected = 0;       ///< samples of these that were not finite
  std::string cause;                ///< of the first one, see `cause_text`; empty if there is none
  std::optional<grf::Vec3d> where;  ///< the same in the world; empty if it is not on a surface
};

/// Renders a request's image, at most 256 pixels wide, with 64 samples per pixel, and explains the first
/// sample that is not finite. Returns nothing after an error or a requested stop.
std::optional<NonFiniteSearch> search_non_finite(const PreviewRequest& request, const std::stop_token& stop,
                                                 grf::Diagnostics& diagnostics);

}  // namespace job
