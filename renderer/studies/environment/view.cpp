#include "renderer/studies/environment/view.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "grf/srgb.h"
#include "renderer/image/encoders.h"
#include "renderer/parallel/loops.h"
#include "renderer/reflectance/geometry.h"
#include "renderer/studies/angles.h"

namespace studies {
namespace {

using plot::Anchor;
using plot::Point;
using reflectance::Rgb;
using reflectance::Vec3f;

constexpr double PixelsPerUnit = 1.5;  // of the sphere's picture
constexpr double RimWidth = 0.8;
// Two lines, so that the horizon shows on dark and on light ground. These near-greys are not inverted.
constexpr std::string_view LightLine = "#fffffe";
constexpr std::string_view DarkLine = "#202021";
constexpr std::string_view HiddenLine = "#8b8b8c";

void draw_line(std::span<const Point> line, plot::Svg& svg) {
  svg.polyline(line, {LightLine, 2.2});
  svg.polyline(line, {DarkLine, 1, "4 3"});
}

/// Returns the points of the horizon, a full turn.
std::vector<Vec3f> horizon_of(const Vec3f& normal) {
  const reflectance::Frame frame(normal);
  std::vector<Vec3f> directions;
  for (int degrees = 0; degrees <= 360; ++degrees)
    directions.push_back(frame.to_world(direction_of({90 * Degree, degrees * Degree})));
  return directions;
}

/// Calls draw(run, is_in_front) for each run of points on one side of the sphere.
template <class Draw>
void for_each_run(const std::vector<Vec3f>& directions, const SphereView& view, const Draw& draw_run) {
  std::vector<Point> run;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const bool is_front = view.is_in_front(directions[i]);
    run.push_back(view.point(directions[i]));
    const bool goes_on = i + 1 < directions.size() && view.is_in_front(directions[i + 1]) == is_front;
    if (goes_on) continue;
    draw_run(run, is_front);
    run.clear();
  }
}

/// The colour of a pixel of the sphere's picture, by the part of it that the sphere covers.
Rgb pixel_of(const ColouredSphere& sphere, const SphereView& view, const Point& middle, double side,
             const Rgb& background) {
  const double from_centre = (middle - view.centre()).length();
  const double coverage = std::clamp((view.radius() - from_centre) / side + 0.5, 0.0, 1.0);
  if (coverage <= 0) return background;
  const double inwards = from_centre > 0 ? std::min(1.0, 0.9999 * view.radius() / from_centre) : 1;
  const auto direction = view.direction(view.centre() + (middle - view.centre()) * inwards);
  const auto share = static_cast<float>(coverage);
  return sphere.colour(*direction) * share + background * (1 - share);
}

}  // namespace

Point UnrolledView::point(const Vec3f& direction) const {
  const MapPosition at = map_position(direction);
  return place_.corner + Point(at.across * place_.width, at.down * place_.height);
}

std::optional<Vec3f> UnrolledView::direction(const Point& point) const {
  const Point inside = point - place_.corner;
  const double across = inside.x / place_.width;
  const double down = inside.y / place_.height;
  if (!(across >= 0 && across < 1 && down >= 0 && down < 1)) return std::nullopt;
  return map_direction(across, down);
}

SphereView::SphereView(double azimuth, double elevation, const Point& centre, double radius)
    : centre_(centre), radius_(radius) {
  const double a = azimuth * Degree;
  const double e = elevation * Degree;
  to_eye_ = Vec3f(Imath::V3d(std::cos(e) * std::cos(a), std::sin(e), -std::cos(e) * std::sin(a)));
  right_ = Vec3f(Imath::V3d(-std::sin(a), 0, -std::cos(a)));
  up_ = to_eye_.cross(right_);
}

Point SphereView::point(const Vec3f& position) const {
  return centre_ + Point(position.dot(right_), -position.dot(up_)) * radius_;
}

std::optional<Vec3f> SphereView::direction(const Point& point) const {
  const Point at = (point - centre_) / radius_;
  const double depth2 = 1 - at.length2();
  if (!(depth2 >= 0)) return std::nullopt;
  return right_ * static_cast<float>(at.x) - up_ * static_cast<float>(at.y) +
         to_eye_ * static_cast<float>(std::sqrt(depth2));
}

Rgb ColouredSphere::colour(const Vec3f& direction) const {
  const MapPosition at = map_position(direction);
  const double x = at.across * grid.width - 0.5;
  const double y = std::clamp(at.down * grid.height - 0.5, 0.0, grid.height - 1.0);
  const int left = static_cast<int>(std::floor(x));
  const int top = std::min(static_cast<int>(y), grid.height - 2);
  const auto of = [&](int column, int row) {
    const int wrapped = (column + grid.width) % grid.width;
    return colours[static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.width) +
                   static_cast<std::size_t>(wrapped)];
  };
  const auto across = static_cast<float>(x - left);
  const auto down = static_cast<float>(y - top);
  return (of(left, top) * (1 - across) + of(left + 1, top) * across) * (1 - down) +
         (of(left, top + 1) * (1 - across) + of(left + 1, top + 1) * across) * down;
}

void draw(const ColouredSphere& sphere, const SphereView& view, const UnrolledView& unrolled,
          plot::Svg& svg) {
  const int side = 2 * static_cast<int>(std::ceil(PixelsPerUnit / 2 * (2 * view.radius() + 2)));
  const double size = side / PixelsPerUnit;
  const Point corner = view.centre() - Point(size, size) / 2;
  const Rgb background = grf::srgb_decoded(svg.shaded(grf::Colour(1)));
  std::string round_png;
  std::string flat_png;
  parallel::invoke(
      [&] {
        image::Image image{side, side, {}};
        image.pixels.reserve(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
        for (int y = 0; y < side; ++y) {
          for (int x = 0; x < side; ++x) {
            const Point middle = corner + Point(x + 0.5, y + 0.5) / PixelsPerUnit;
            image.pixels.push_back(pixel_of(sphere, view, middle, 1 / PixelsPerUnit, background));
          }
        }
        round_png = image::encode_png({image});
      },
      [&] {
        flat_png = image::encode_png({{sphere.grid.width, sphere.grid.height, sphere.colours}});
      });
  svg.image(corner, size, size, round_png);
  svg.image(unrolled.place().corner, unrolled.place().width, unrolled.place().height, flat_png);
}

void draw_axes(const UnrolledView& view, plot::Svg& svg) {
  const plot::Rectangle& place = view.place();
  const Point& corner = place.corner;
  const double right = corner.x + place.width;
  const double bottom = corner.y + place.height;
  const std::array<Point, 5> border = {corner, Point(right, corner.y), Point(right, bottom),
                                       Point(corner.x, bottom), corner};
  svg.polyline(border, {"#888", 1});
  constexpr std::array<std::string_view, 5> Names = {
      "270\u00B0, +z", "180\u00B0, \u2212x", "90\u00B0, \u2212z", "0\u00B0, +x", "\u221290\u00B0, +z"};
  for (std::size_t i = 0; i < Names.size(); ++i) {
    const double x = corner.x + place.width * static_cast<double>(i) / 4;
    svg.line({x, bottom}, {x, bottom + 4}, {"#888", 1});
    svg.text({x, bottom + 16}, Names[i], {11, "#333", Anchor::Middle, 0});
  }
  for (int elevation = -90; elevation <= 90; elevation += 30) {
    const double y = bottom - place.height * (elevation + 90) / 180;
    svg.line({corner.x - 4, y}, {corner.x, y}, {"#888", 1});
    const std::string_view sign = elevation < 0 ? "\u2212" : "";
    svg.text({corner.x - 7, y + 4}, fmt::format("{}{}\u00B0", sign, std::abs(elevation)),
             {11, "#333", Anchor::End, 0});
  }
}

void draw_horizon(const Vec3f& normal, const UnrolledView& view, plot::Svg& svg) {
  std::vector<Point> line;
  for (const Vec3f& direction : horizon_of(normal)) {
    const Point at = view.point(direction);
    // The line leaves at one side and enters again at the other.
    if (!line.empty() && std::abs(at.x - line.back().x) > view.place().width / 2) {
      draw_line(line, svg);
      line.clear();
    }
    line.push_back(at);
  }
  draw_line(line, svg);
}

void draw_horizon(const Vec3f& normal, const SphereView& view, plot::Svg& svg) {
  const std::vector<Vec3f> horizon = horizon_of(normal);
  for_each_run(horizon, view, [&](const std::vector<Point>& run, bool is_front) {
    if (!is_front) svg.polyline(run, {HiddenLine, 0.8, "2 3"});
  });
  for_each_run(horizon, view, [&](const std::vector<Point>& run, bool is_front) {
    if (is_front) draw_line(run, svg);
  });
}

void draw_dots(std::span<const Vec3f> directions, const DotStyle& style, const UnrolledView& view,
               plot::Svg& svg) {
  std::vector<Point> points;
  for (const Vec3f& direction : directions) points.push_back(view.point(direction));
  if (points.empty()) return;
  if (!style.rim.empty()) svg.dots(points, style.radius + RimWidth, style.rim);
  svg.dots(points, style.radius, style.colour);
}

void draw_dots(std::span<const Vec3f> directions, const DotStyle& style, const SphereView& view,
               plot::Svg& svg) {
  std::vector<Point> front;
  std::vector<Point> back;
  for (const Vec3f& direction : directions)
    (view.is_in_front(direction) ? front : back).push_back(view.point(direction));
  if (!back.empty()) svg.dots(back, 0.7 * style.radius, style.faint);
  if (front.empty()) return;
  if (!style.rim.empty()) svg.dots(front, style.radius + RimWidth, style.rim);
  svg.dots(front, style.radius, style.colour);
}

}  // namespace studies
