// What the view draws besides the scene: background, grid and axes, things to take, and the gesture that is
// being made.
#include <QLinearGradient>
#include <QPainter>

#include "editor/appearance/theme.h"
#include "editor/view/ground_grid.h"
#include "editor/view/scene_view.h"

namespace editor {
namespace {

using grf::Vec3d;

QColor with_alpha(QColor colour, double alpha) {
  colour.setAlphaF(static_cast<float>(alpha));
  return colour;
}

QColor axis_colour(int axis) {
  static constexpr std::array<QRgb, 3> Colours = {0xffe0524b, 0xff6aa84f, 0xff4a86e8};
  return QColor::fromRgb(Colours[static_cast<std::size_t>(axis)]);
}

Vec3d flat(const QPointF& point) { return {point.x(), point.y(), 0}; }

}  // namespace

ViewColours SceneView::colours() const {
  const Theme theme = theme_of(palette());
  const ThemeColours colours = colours_of(theme);
  return {theme == Theme::Dark ? colours.base.lighter(135) : colours.base,
          theme == Theme::Dark ? colours.base : colours.base.darker(112), colours.accent};
}

void SceneView::paint_background(QPainter& painter) const {
  const ViewColours background = colours();
  QLinearGradient gradient(0, 0, 0, height());
  gradient.setColorAt(0, background.background_top);
  gradient.setColorAt(1, background.background_bottom);
  painter.fillRect(rect(), gradient);
}

std::vector<OverlayLayer> SceneView::overlay() const {
  std::vector<OverlayLayer> layers;
  if (has_grid_) add_grid(layers);
  add_handles(layers);
  return layers;
}

void SceneView::add_grid(std::vector<OverlayLayer>& layers) const {
  const GroundGrid grid = ground_grid(objects_->bounds);
  const QColor line = with_alpha(colours_of(theme_of(palette())).line, 0.45);
  std::vector<OverlayLine> lines;
  const int steps = qRound(grid.half_size / grid.step);
  for (int i = -steps; i <= steps; ++i) {
    if (i == 0) continue;
    const double at = i * grid.step;
    lines.push_back({{at, 0, -grid.half_size}, {at, 0, grid.half_size}, line});
    lines.push_back({{-grid.half_size, 0, at}, {grid.half_size, 0, at}, line});
  }
  layers.push_back({std::move(lines), 1, 0, false});
  std::vector<OverlayLine> axes;
  for (int axis = 0; axis < 3; axis += 2) {
    Vec3d end(0);
    end[axis] = grid.half_size;
    axes.push_back({-end, end, with_alpha(axis_colour(axis), 0.8)});
  }
  layers.push_back({std::move(axes), 1.5, 0, false});
  // The axes' directions, in the lower left corner.
  std::vector<OverlayLine> corner;
  const QPointF middle(40, height() - 40);
  for (int axis = 0; axis < 3; ++axis) {
    Vec3d along(0);
    along[axis] = 26;
    const QPointF end(along.dot(camera_.right()), -along.dot(camera_.up()));
    corner.push_back({flat(middle), flat(middle + end), axis_colour(axis)});
  }
  layers.push_back({std::move(corner), 2.5, 0, true});
}

void SceneView::add_handles(std::vector<OverlayLayer>& layers) const {
  const ThemeColours colours = colours_of(theme_of(palette()));
  std::vector<OverlayLine> lines;
  std::vector<OverlayLine> grips;
  const double aspect_ratio = aspect();
  for (std::size_t i = 0; i < handles_.size(); ++i) {
    const SceneHandle handle = taken_ == i ? moved(handles_[i], taken_offset_) : handles_[i];
    const bool is_lit = taken_ == i || hovered_handle_ == handle.id;
    QColor colour = handle.id.kind == HandleKind::Light      ? colours.warning
                    : handle.id.kind == HandleKind::Observer ? series_colour(theme_of(palette()), 2)
                                                             : series_colour(theme_of(palette()), 1);
    if (is_lit) colour = colours.accent;
    for (const auto& [from, to] : handle.lines) lines.push_back({from, to, colour});
    const auto place = camera_.place_of(handle.grip, aspect_ratio);
    if (!place) continue;
    const Vec3d at((0.5 + 0.5 * place->x) * width(), (0.5 - 0.5 * place->y) * height(), 0);
    const int half = is_lit ? 5 : 4;
    for (int y = -half; y <= half; ++y) {
      grips.push_back({at + Vec3d(-half, y, 0), at + Vec3d(half, y, 0), colour});
    }
  }
  layers.push_back({std::move(lines), 1.5, 0.25, false});
  layers.push_back({std::move(grips), 1, 0, true});
}

void SceneView::paint_gesture(QPainter& painter) const {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(colours().accent, 1.5));
  if (gesture_ == Gesture::Region && !is_click_) painter.drawPolygon(region_);
  if (!shows_middle_ || !hasFocus()) return;
  const QPointF middle(width() / 2.0, height() / 2.0);
  for (const QPointF& way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)}) {
    painter.drawLine(middle + way * 4, middle + way * 12);
  }
}

}  // namespace editor
