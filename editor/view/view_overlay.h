// What the view draws besides the scene: background, grid, axes and handles.
#pragma once

#include <QPalette>
#include <vector>

#include "editor/view/overlay_painter.h"
#include "editor/view/scene_handles.h"
#include "editor/view/view_state.h"

namespace editor {

ViewColours view_colours(const QPalette& palette);

/// A square on the plane y = 0 about the origin, in steps of a power of ten.
struct GroundGrid {
  double step = 1;
  double half_size = 10;

  grf::Box3d bounds() const { return {{-half_size, 0, -half_size}, {half_size, 0, half_size}}; }
};

/// One that reaches somewhat further than the scene, with 10 to 100 steps.
GroundGrid ground_grid(const grf::Box3d& bounds);

/// The grid with its axes; and their directions, in the lower left corner of a window of that height.
void add_grid(const GroundGrid& grid, const ViewCamera& camera, double height, const QPalette& palette,
              std::vector<OverlayLayer>& layers);

/// Handles in a window of that size, the one that is pointed at in another colour.
void add_handles(const HandleGesture& gesture, const ViewCamera& camera, const grf::Vec2d& size,
                 const QPalette& palette, std::vector<OverlayLayer>& layers);

}  // namespace editor
