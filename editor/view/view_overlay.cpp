#include "editor/view/view_overlay.h"

#include <algorithm>
#include <cmath>

#include "editor/appearance/theme.h"
#include "editor/view/screen_geometry.h"

namespace editor {
namespace {

using grf::Vec3d;

QColor with_alpha(QColor colour, double alpha) {
  colour.setAlphaF(static_cast<float>(alpha));
  return colour;
}

QColor handle_colour(HandleKind kind, Theme theme) {
  if (kind == HandleKind::Light) return colours_of(theme).warning;
  return series_colour(theme, kind == HandleKind::Observer ? 2 : 1);
}

}  // namespace

QColor axis_colour(int axis) {
  static constexpr std::array<QRgb, 3> Colours = {0xffe0524b, 0xff6aa84f, 0xff4a86e8};
  return QColor::fromRgb(Colours[static_cast<std::size_t>(axis)]);
}

ViewColours view_colours(const QPalette& palette) {
  const Theme theme = theme_of(palette);
  const ThemeColours colours = colours_of(theme);
  return {theme == Theme::Dark ? colours.base.lighter(135) : colours.base,
          theme == Theme::Dark ? colours.base : colours.base.darker(112), colours.accent};
}

GroundGrid ground_grid(const grf::Box3d& bounds) {
  if (bounds.isEmpty()) return {};
  double reach = bounds.size().length() / 2;
  for (const double x : {bounds.min.x, bounds.max.x, bounds.min.z, bounds.max.z}) {
    reach = std::max(reach, std::min(std::abs(x), 4 * bounds.size().length()));
  }
  reach = std::max(reach, 1e-6);
  const double step = std::pow(10, std::floor(std::log10(reach * 1.2)));
  const double finer = reach * 1.2 < 3 * step ? step / 5 : step;
  return {finer, std::ceil(reach * 1.2 / finer) * finer};
}

void add_grid(const GroundGrid& grid, const ViewCamera& camera, double height, const QPalette& palette,
              std::vector<OverlayLayer>& layers) {
  const QColor line = with_alpha(colours_of(theme_of(palette)).line, 0.45);
  std::vector<OverlayLine> lines;
  const int steps = qRound(grid.half_size / grid.step);
  for (int i = -steps; i <= steps; ++i) {
    if (i == 0) continue;
    const double at = i * grid.step;
    lines.push_back({{at, 0, -grid.half_size}, {at, 0, grid.half_size}, line});
    lines.push_back({{-grid.half_size, 0, at}, {grid.half_size, 0, at}, line});
  }
  layers.push_back({std::move(lines), 1, 0, false});
  std::vector<OverlayLine> axes, corner;
  const Vec3d middle(40, height - 40, 0);
  for (int axis = 0; axis < 3; ++axis) {
    Vec3d along(0);
    along[axis] = 1;
    const Vec3d end = along * grid.half_size;
    if (axis != 1) axes.push_back({-end, end, with_alpha(axis_colour(axis), 0.8)});
    const Vec3d on_screen(along.dot(camera.right()), -along.dot(camera.up()), 0);
    corner.push_back({middle, middle + on_screen * 26, axis_colour(axis)});
  }
  layers.push_back({std::move(axes), 1.5, 0, false});
  layers.push_back({std::move(corner), 2.5, 0, true});
}

void add_framing(double aspect, const grf::Vec2d& size, const QPalette& palette,
                 std::vector<OverlayLayer>& layers) {
  const QColor text = colours_of(theme_of(palette)).text;
  const double width = size.y * aspect;
  const double left = (size.x - width) / 2;
  std::vector<OverlayLine> border, thirds;
  for (int i = 0; i <= 3; ++i) {
    const bool is_border = i % 3 == 0;
    std::vector<OverlayLine>& lines = is_border ? border : thirds;
    const QColor colour = with_alpha(text, is_border ? 0.7 : 0.3);
    const double x = left + width * i / 3;
    const double y = std::clamp(size.y * i / 3, 1.0, size.y - 1);  // the border is within the window
    lines.push_back({{x, 0, 0}, {x, size.y, 0}, colour});
    lines.push_back({{left, y, 0}, {left + width, y, 0}, colour});
  }
  layers.push_back({std::move(thirds), 1, 0, true});
  layers.push_back({std::move(border), 1.5, 0, true});
}

void add_handles(const HandleGesture& gesture, const ViewCamera& camera, const grf::Vec2d& size,
                 const QPalette& palette, std::vector<OverlayLayer>& layers) {
  const Theme theme = theme_of(palette);
  std::vector<OverlayLine> lines, grips;
  for (std::size_t i = 0; i < gesture.handles().size(); ++i) {
    const SceneHandle handle = gesture.shown(i);
    const bool is_lit = gesture.is_lit(i);
    const QColor colour = is_lit ? colours_of(theme).accent : handle_colour(handle.id.kind, theme);
    for (const auto& [from, to] : handle.lines) lines.push_back({from, to, colour});
    const auto pixel = pixel_of(handle.grip, camera, size);
    if (!pixel) continue;
    const Vec3d at(pixel->x, pixel->y, 0);
    const int half = is_lit ? 5 : 4;
    for (int y = -half; y <= half; ++y) {
      grips.push_back({at + Vec3d(-half, y, 0), at + Vec3d(half, y, 0), colour});
    }
  }
  layers.push_back({std::move(lines), 1.5, 0.25, false});
  layers.push_back({std::move(grips), 1, 0, true});
}

}  // namespace editor
