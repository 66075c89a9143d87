#pragma once

#include "renderer/studies/study.h"

namespace studies {

/// The tool `emviewer` (the thesis' section 6.1.6): resampling of the product of a BRDF and an environment
/// map (section 5.5), with candidates and samples on the sphere and on the unrolled map, the densities, and
/// the quality of the estimate. Without a file it shows a built-in sky.
StudyTool environment_viewer_tool();

}  // namespace studies
