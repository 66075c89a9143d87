#pragma once

#include "renderer/plot/chart.h"
#include "renderer/studies/subdivision/subject.h"

namespace studies {

/// Draws 16 by 16 strata of uniform pairs in the unit square, and where `adaptive mode=warp` and the
/// subject's own scheme put them on the disc: a warp keeps neighbours together, rejection does not.
void draw_strata(const SubdivisionSubject& subject, const plot::Rectangle& place, plot::Svg& svg);

}  // namespace studies
