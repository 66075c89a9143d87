#include "renderer/studies/lobe_figure.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "renderer/studies/angles.h"

namespace studies {
namespace {

using plot::Point;
using reflectance::Vec3f;

constexpr double DotRadius = 1.3;
constexpr double LargeDotRadius = 2.5;
constexpr std::size_t FewDots = 200;
/// How much nearer a dot counts than a facet, so that dots on the lobe are not half hidden by it.
constexpr double DotLead = 0.02;

/// A facet of the lobe or a dot, in the order in which they are drawn.
struct Item {
  double nearness = 0;
  std::size_t facet = 0;  ///< index of its first vertex, unless it is a dot
  const Vec3f* dot = nullptr;
  std::string_view colour;
};

void draw_surface(const HemisphereView& view, plot::Svg& svg) {
  for (const double radius : {0.5, 1.0}) {
    std::vector<Point> circle;
    for (int degrees = 0; degrees <= 360; degrees += 3) {
      const double angle = degrees * Degree;
      circle.push_back(view.point(Vec3f(Imath::V3d(radius * std::cos(angle), radius * std::sin(angle), 0))));
    }
    svg.polyline(circle, {radius < 1 ? "#ddd" : "#999", 0.8});
  }
  const auto axis = [&](const Vec3f& end, std::string_view name) {
    svg.line(view.point(-end), view.point(end), {"#ccc", 0.8});
    svg.text(view.point(1.07F * end) + Point(0, 4), name, {11, "#666", plot::Anchor::Middle, 0});
  };
  axis({1, 0, 0}, "x");
  axis({0, 1, 0}, "y");
}

grf::Colour shade_of(const Vec3f& normal, const grf::Colour& colour, const HemisphereView& view) {
  const float facing = std::abs(normal.dot(view.to_eye()));
  const float light = 0.45F + 0.55F * facing;
  return colour * light + grf::Colour(1) * (1 - light) * 0.25F;
}

}  // namespace

HemisphereView::HemisphereView(double azimuth, double elevation, const plot::Rectangle& place) {
  const double a = azimuth * Degree;
  const double e = elevation * Degree;
  right_ = Vec3f(Imath::V3d(-std::sin(a), std::cos(a), 0));
  to_eye_ = Vec3f(Imath::V3d(std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)));
  up_ = to_eye_.cross(right_);
  // The hemisphere reaches from the disc's near rim below to its top.
  const double below = std::abs(std::sin(e));
  scale_ = std::min(place.width / 2.3, place.height / (below + 1.15));
  centre_ = {place.corner.x + place.width / 2, place.corner.y + place.height - scale_ * (below + 0.06)};
}

Point HemisphereView::point(const Vec3f& position) const {
  return {centre_.x + scale_ * position.dot(right_), centre_.y - scale_ * position.dot(up_)};
}

void draw_lobe(const plot::LobeMesh& mesh, const plot::LobeGrid& grid, std::string_view colour,
               std::span<const PointCloud> clouds, const HemisphereView& view, plot::Svg& svg) {
  draw_surface(view, svg);
  const grf::Colour plain = plot::colour_of(colour).value_or(grf::Colour(0.5F));
  const auto sectors = static_cast<std::size_t>(grid.sectors);
  const auto corners_of = [&](std::size_t vertex) {
    const std::size_t next = vertex % sectors + 1 < sectors ? vertex + 1 : vertex + 1 - sectors;
    return std::array{vertex, next, next + sectors, vertex + sectors};
  };
  std::vector<Item> items;
  std::size_t dot_count = 0;
  for (const PointCloud& cloud : clouds) dot_count += cloud.positions.size();
  const double dot_radius = dot_count <= FewDots ? LargeDotRadius : DotRadius;
  for (std::size_t vertex = 0; mesh.peak > 0 && vertex + sectors < mesh.positions.size(); ++vertex) {
    Item facet;
    facet.facet = vertex;
    for (const std::size_t corner : corners_of(vertex))
      facet.nearness += view.nearness(mesh.positions[corner]) / 4;
    items.push_back(facet);
  }
  for (const PointCloud& cloud : clouds) {
    for (const Vec3f& position : cloud.positions)
      items.push_back({view.nearness(position) + DotLead, 0, &position, cloud.colour});
  }
  std::ranges::sort(items, {}, &Item::nearness);
  std::vector<Point> dots;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const Item& item = items[i];
    if (item.dot != nullptr) {
      dots.push_back(view.point(*item.dot));
      const bool goes_on =
          i + 1 < items.size() && items[i + 1].dot != nullptr && items[i + 1].colour == item.colour;
      if (goes_on) continue;
      svg.dots(dots, dot_radius, item.colour);
      dots.clear();
      continue;
    }
    std::array<Point, 4> corners;
    Vec3f normal(0);
    const auto vertices = corners_of(item.facet);
    for (std::size_t k = 0; k < 4; ++k) {
      corners[k] = view.point(mesh.positions[vertices[k]]);
      normal += mesh.normals[vertices[k]];
    }
    svg.polygon(corners, plot::hexadecimal(shade_of(normal.normalized(), plain, view)), 0.4);
  }
}

void draw_direction(const Vec3f& direction, std::string_view name, std::string_view dashes,
                    const HemisphereView& view, plot::Svg& svg) {
  const Point end = view.point(direction);
  svg.line(view.point(Vec3f(0)), end, {"#333", 1, dashes});
  svg.text(end + Point(0, -5), name, {11, "#333", plot::Anchor::Middle, 0});
}

void draw_view_directions(const Vec3f& u, const HemisphereView& view, plot::Svg& svg) {
  draw_direction({0, 0, 1}, "n", "2 3", view, svg);
  draw_direction(u, "view", "", view, svg);
  draw_direction(reflectance::mirrored(u), "mirror", "6 3", view, svg);
}

}  // namespace studies
