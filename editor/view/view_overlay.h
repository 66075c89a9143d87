// The overlay of the view has the background, the grid, axes and handles.
#pragma once

#include <QPalette>
#include <vector>

#include "editor/view/overlay_painter.h"
#include "editor/view/scene_handles.h"
#include "editor/view/view_state.h"

namespace editor {

ViewColours view_colours(const QPalette& palette);
/// The colour of the x, y or z axis.
QColor axis_colour(int axis);

/// A square grid on the plane y = 0 about the origin, with a power of ten as its step.
struct GroundGrid {
  double step = 1;
  double half_size = 10;

  grf::Box3d bounds() const { return {{-half_size, 0, -half_size}, {half_size, 0, half_size}}; }
};

/// Creates a grid somewhat larger than the scene, with 10 to 100 steps.
GroundGrid ground_grid(const grf::Box3d& bounds);

/// Adds the grid with its axes; and the axes' directions, in the lower left corner of a window of that
/// height.
void add_grid(const GroundGrid& grid, const ViewCamera& camera, double height, const QPalette& palette,
              std::vector<OverlayLayer>& layers);

/// Adds the border of an image of this aspect, width over height, which is as high as the window, and its
/// thirds.
void add_framing(double aspect, const grf::Vec2d& size, const QPalette& palette,
                 std::vector<OverlayLayer>& layers);

/// Adds the handles in a window of that size, with the hovered one highlighted.
void add_handles(const HandleGesture& gesture, const ViewCamera& camera, const grf::Vec2d& size,
                 const QPalette& palette, std::vector<OverlayLayer>& layers);

}  // namespace editor
