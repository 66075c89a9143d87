#pragma once

#include "renderer/studies/study.h"

namespace studies {

/// The tool `subdivision`: the adaptive quadtree of a BRDF on the unit disc (the thesis' chapter 5 and
/// section 6.2.3), with samples of a scheme or of a FIT file, and sampling schemes side by side.
StudyTool subdivision_tool();

}  // namespace studies
