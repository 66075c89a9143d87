#pragma once

#include <string>

#include "grf/diagnostics.h"
#include "renderer/options/render_options.h"
#include "renderer/transport/render.h"

namespace command {

/// Writes the reports that the options request beside the image: the memory of the sampling schemes' tables
/// to `mem.op`, with a line per pair of BRDF and scheme and one for the sum, and times in seconds, appended
/// as a line each, to `samplingTime`, `renderingTime` and `prebuildTime`. Returns false after an error.
bool write_reports(const transport::Render& render, const transport::CompiledScene& scene,
                   const options::RenderOptions& render_options, const std::string& image,
                   grf::Diagnostics& diagnostics);

}  // namespace command
