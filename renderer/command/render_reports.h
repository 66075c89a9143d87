#pragma once

#include <string>

#include "grf/diagnostics.h"
#include "renderer/options/render_options.h"
#include "renderer/transport/render.h"

namespace command {

/// Writes what the options ask for beside the image: the memory of the sampling schemes' tables to `mem.op`,
/// with a line for each pair of BRDF and scheme and one for the sum, and seconds, each appended as a line, to
/// `samplingTime`, `renderingTime` and `prebuildTime`. False after an error.
bool write_reports(const transport::Render& render, const transport::CompiledScene& scene,
                   const options::RenderOptions& render_options, const std::string& image,
                   grf::Diagnostics& diagnostics);

}  // namespace command
