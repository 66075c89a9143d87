// Converts between world space and pixels of a window, counted from its upper left corner.
#pragma once

#include <optional>

#include "editor/view/view_camera.h"

namespace editor {

/// Projects a point; nothing for one that is not in front of the eye.
std::optional<grf::Vec2d> pixel_of(const grf::Vec3d& point, const ViewCamera& camera, const grf::Vec2d& size);
/// The position of a pixel in the image, see ViewCamera.
grf::Vec2d place_of_pixel(const grf::Vec2d& pixel, const grf::Vec2d& size);
/// The distance of a point from a line segment.
double distance_to_line(const grf::Vec2d& point, const grf::Vec2d& from, const grf::Vec2d& to);

}  // namespace editor
