#pragma once

#include "renderer/studies/study.h"

namespace studies {

/// The tool `minibpt` (the thesis' section 6.1.4): the path tracer on a shape over a floor, or on a scene
/// with its options, refined while one changes it. Two BRDFs or sampling schemes can be compared in equal
/// time.
StudyTool mini_render_tool();

}  // namespace studies
