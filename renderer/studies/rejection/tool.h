#pragma once

#include "renderer/studies/study.h"

namespace studies {

/// The study of rejection sampling: of statistical distributions and of f cos (section 6.2.1 of the thesis).
StudyTool rejection_tool();

}  // namespace studies
