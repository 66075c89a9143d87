#include "editor/view/screen_geometry.h"

#include <algorithm>

namespace editor {

std::optional<grf::Vec2d> pixel_of(const grf::Vec3d& point, const ViewCamera& camera,
                                   const grf::Vec2d& size) {
  const auto place = camera.place_of(point, size.x / size.y);
  if (!place) return std::nullopt;
  return grf::Vec2d((0.5 + 0.5 * place->x) * size.x, (0.5 - 0.5 * place->y) * size.y);
}

grf::Vec2d place_of_pixel(const grf::Vec2d& pixel, const grf::Vec2d& size) {
  return {2 * pixel.x / size.x - 1, 1 - 2 * pixel.y / size.y};
}

double distance_to_line(const grf::Vec2d& point, const grf::Vec2d& from, const grf::Vec2d& to) {
  const grf::Vec2d along = to - from;
  const double length2 = along.length2();
  const double t = length2 > 0 ? std::clamp((point - from).dot(along) / length2, 0.0, 1.0) : 0;
  return (from + along * t - point).length();
}

}  // namespace editor
