// What the view draws over the picture: grid and axes, things to take, and the gesture that is being made.
#include <QVector3D>

#include "editor/appearance/theme.h"
#include "editor/view/ground_grid.h"
#include "editor/view/scene_view_graphics.h"

namespace editor {
namespace {

using grf::Vec3d;

QVector3D rgb(const QColor& colour) { return {colour.redF(), colour.greenF(), colour.blueF()}; }

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

void SceneView::compose() {
  Gl& gl = graphics_->gl;
  const Theme theme = theme_of(palette());
  const ThemeColours colours = colours_of(theme);
  const double ratio = devicePixelRatioF();
  gl.glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
  gl.glViewport(0, 0, qRound(width() * ratio), qRound(height() * ratio));
  gl.glDisable(GL_BLEND);
  gl.glDisable(GL_SCISSOR_TEST);
  gl.glEnable(GL_DEPTH_TEST);
  gl.glDepthFunc(GL_ALWAYS);
  gl.glDepthMask(GL_TRUE);
  QOpenGLShaderProgram& program = *graphics_->compose;
  program.bind();
  set_picture_units(program);
  graphics_->pictures.bind_shown(program);
  program.setUniformValue("background_top",
                          rgb(theme == Theme::Dark ? colours.base.lighter(135) : colours.base));
  program.setUniformValue("background_bottom",
                          rgb(theme == Theme::Dark ? colours.base : colours.base.darker(112)));
  program.setUniformValue("height", static_cast<float>(height() * ratio));
  program.setUniformValue("accent", rgb(colours.accent));
  program.setUniformValue("fill", 0.45F);
  gl.glBindVertexArray(graphics_->no_vertices.name());
  gl.glDrawArrays(GL_TRIANGLES, 0, 3);
}

void SceneView::draw_overlay() {
  if (has_grid_) draw_grid();
  draw_handles();
  draw_gesture();
  Gl& gl = graphics_->gl;
  gl.glBindVertexArray(0);
  gl.glUseProgram(0);
  gl.glActiveTexture(GL_TEXTURE0);
}

void SceneView::draw_grid() {
  const GroundGrid grid = ground_grid(objects_.bounds);
  const QColor line = with_alpha(colours_of(theme_of(palette())).line, 0.45);
  std::vector<OverlayLine> lines;
  const int steps = qRound(grid.half_size / grid.step);
  for (int i = -steps; i <= steps; ++i) {
    if (i == 0) continue;
    const double at = i * grid.step;
    lines.push_back({{at, 0, -grid.half_size}, {at, 0, grid.half_size}, line});
    lines.push_back({{-grid.half_size, 0, at}, {grid.half_size, 0, at}, line});
  }
  const OverlayPainter::Screen screen{window_size(), devicePixelRatioF()};
  graphics_->overlay.draw(lines, camera_, drawn_bounds(), screen, 1, 0);
  std::vector<OverlayLine> axes;
  for (int axis = 0; axis < 3; axis += 2) {
    Vec3d end(0);
    end[axis] = grid.half_size;
    axes.push_back({-end, end, with_alpha(axis_colour(axis), 0.8)});
  }
  graphics_->overlay.draw(axes, camera_, drawn_bounds(), screen, 1.5, 0);
  // The axes' directions, in the lower left corner.
  std::vector<OverlayLine> corner;
  const QPointF middle(40, height() - 40);
  for (int axis = 0; axis < 3; ++axis) {
    Vec3d along(0);
    along[axis] = 26;
    const QPointF end(along.dot(camera_.right()), -along.dot(camera_.up()));
    corner.push_back({flat(middle), flat(middle + end), axis_colour(axis)});
  }
  graphics_->overlay.draw_flat(corner, screen, 2.5);
}

void SceneView::draw_handles() {
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
  const OverlayPainter::Screen screen{window_size(), devicePixelRatioF()};
  graphics_->overlay.draw(lines, camera_, drawn_bounds(), screen, 1.5, 0.25);
  graphics_->overlay.draw_flat(grips, screen, 1);
}

void SceneView::draw_gesture() {
  const ThemeColours colours = colours_of(theme_of(palette()));
  std::vector<OverlayLine> lines;
  if (gesture_ == Gesture::Region && !is_click_) {
    for (int i = 0; i < region_.size(); ++i) {
      lines.push_back({flat(region_[i]), flat(region_[(i + 1) % region_.size()]), colours.accent});
    }
  }
  if (shows_middle_ && hasFocus()) {
    const QPointF middle(width() / 2.0, height() / 2.0);
    for (const QPointF& way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)}) {
      lines.push_back({flat(middle + way * 4), flat(middle + way * 12), colours.accent});
    }
  }
  graphics_->overlay.draw_flat(lines, {window_size(), devicePixelRatioF()}, 1.5);
}

}  // namespace editor
