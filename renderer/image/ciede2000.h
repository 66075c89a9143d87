// CIELAB colours and the CIEDE2000 difference between them.
#pragma once

#include "grf/math.h"

namespace image {

/// A colour of CIELAB: lightness from 0 to 100, and two opponent axes.
struct Lab {
  double lightness = 0;
  double a = 0;
  double b = 0;
};

/// Converts from XYZ, relative to a white of luminance 1 (CIE 15).
Lab lab_of(const grf::Vec3d& xyz, const grf::Vec3d& white);

/// The CIEDE2000 colour difference with the weights kL = kC = kH = 1: 1 is about what is just noticeable
/// (Sharma, Wu and Dalal 2005, "The CIEDE2000 color-difference formula: implementation notes, supplementary
/// test data, and mathematical observations").
double ciede2000(const Lab& first, const Lab& second);

}  // namespace image
