// Environment maps are resampled, since each renderer has a mapping of directions to its images of its own.
#pragma once

#include "converters/renderers/render_view.h"
#include "renderer/image/image.h"

namespace convert {

/// Returns the radiance from a direction in world space, which need not be of unit length.
grf::Colour radiance_from(const Surroundings& surroundings, const grf::Vec3d& direction);

/// Makes the square image of pbrt-v4's `infinite` light, in world space: the equal-area octahedral mapping of
/// Clarberg 2008, "Fast equal-area mapping of the (hemi)sphere using SIMD", whose centre is +z and whose
/// corners are -z. Texels are means over their directions. The factor of the radiance is left out.
image::Image equal_area_image(const Surroundings& surroundings);

/// Returns the direction of a point of that image, both coordinates 0 to 1 from the upper left corner.
grf::Vec3d equal_area_direction(const grf::Vec2d& point);

/// Makes the image of Mitsuba's `envmap` without a transform, in world space: latitude-longitude with y up,
/// -z at the left and right ends and +x a quarter from the left. The first and last row are the poles.
/// The factor of the radiance is left out.
image::Image mitsuba_latitude_longitude(const Surroundings& surroundings);

}  // namespace convert
