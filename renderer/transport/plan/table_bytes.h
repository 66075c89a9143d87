#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>

#include "grf/diagnostics.h"
#include "grf/scene.h"
#include "renderer/transport/scene/compiled_scene.h"

namespace transport {

/// Returns the bytes that sampling tables hold for each pair of a BRDF's identity and a scheme's text, as a
/// plan has them (PlannedTable), whether or not a path can meet it: they are made for that. What cannot be
/// made is an error if it reflects, and left out if it does not.
std::map<std::pair<std::string, std::string>, std::size_t> table_bytes(const grf::Scene& scene,
                                                                       const CompileSettings& settings,
                                                                       grf::Diagnostics& diagnostics);

}  // namespace transport
