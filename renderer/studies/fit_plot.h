#pragma once

#include "renderer/studies/study.h"

namespace studies {

/// The tool `fitplot`: FIT files (the thesis' section 6.2.4) as a lobe in 3D with clouds of points, on the
/// unit disc, and against the BRDF's own values. Several files are drawn over each other; the lobe is that of
/// the first.
StudyTool fit_plot_tool();

}  // namespace studies
