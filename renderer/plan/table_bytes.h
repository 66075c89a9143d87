#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>

#include "grf/diagnostics.h"
#include "grf/scene.h"
#include "renderer/transport/scene/compiled_scene.h"

namespace plan {

/// Returns the size in bytes of the sampling tables for each pair of a BRDF's identity and a scheme's text,
/// as in a plan (PlannedTable), whether or not a path can hit it: the tables are built for that. A table that
/// cannot be built is an error if the surface reflects, and left out if it does not.
std::map<std::pair<std::string, std::string>, std::size_t> table_bytes(
    const grf::Scene& scene, const transport::CompileSettings& settings, grf::Diagnostics& diagnostics);

}  // namespace plan
