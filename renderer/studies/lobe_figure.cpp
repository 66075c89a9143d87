#include "renderer/studies/lobe_figure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "renderer/studies/angles.h"

namespace studies {
namespace {

using plot::Point;
using reflectance::Vec3f;

constexpr std::string_view LobeColour = "#9ecae1";
constexpr std::string_view SpecularColour = "#2b7bba";
constexpr plot::LobeGrid Grid = {40, 48};
/// The radius beyond which a lobe is cut.
constexpr float LongestRadius = 1.15F;

constexpr double DotRadius = 1.3;
constexpr double LargeDotRadius = 2.5;
constexpr std::ptrdiff_t FewDots = 200;
/// How much nearer a dot counts than a facet, so that dots on the lobe are not half hidden by it.
constexpr double DotLead = 0.02;

/// A facet of the lobe or a dot, in the order in which they are drawn.
struct Item {
  double nearness = 0;
  std::size_t facet = 0;  ///< index of its first vertex, unless it is a dot
  bool is_dot = false;
  Vec3f dot = {};
  std::string_view colour = {};
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

/// Returns the vertices around a facet of the lobe from its first one.
std::array<std::size_t, 4> corners_of(std::size_t vertex) {
  constexpr std::size_t Sectors = Grid.sectors;
  const std::size_t next = vertex % Sectors + 1 < Sectors ? vertex + 1 : vertex + 1 - Sectors;
  return {vertex, next, next + Sectors, vertex + Sectors};
}

void add_facets(const plot::LobeMesh& mesh, const HemisphereView& view, std::vector<Item>& items) {
  for (std::size_t vertex = 0; vertex + Grid.sectors < mesh.positions.size(); ++vertex) {
    Item facet;
    facet.facet = vertex;
    for (const std::size_t corner : corners_of(vertex))
      facet.nearness += view.nearness(mesh.positions[corner]) / 4;
    items.push_back(facet);
  }
}

void draw_facet(const plot::LobeMesh& mesh, std::size_t facet, const grf::Colour& colour,
                const HemisphereView& view, plot::Svg& svg) {
  const auto vertices = corners_of(facet);
  std::array<Point, 4> corners;
  Vec3f normal(0);
  for (std::size_t k = 0; k < 4; ++k) {
    corners[k] = view.point(mesh.positions[vertices[k]]);
    normal += mesh.normals[vertices[k]];
  }
  svg.polygon(corners, plot::hexadecimal(shade_of(normal.normalized(), colour, view)), 0.4);
}

/// Draws sorted items; successive dots of one colour are one element.
void draw_items(const plot::LobeMesh& mesh, const std::vector<Item>& items, const HemisphereView& view,
                plot::Svg& svg) {
  const grf::Colour colour = plot::colour_of(LobeColour).value_or(grf::Colour(0.5F));
  const bool has_few_dots = std::ranges::count(items, true, &Item::is_dot) <= FewDots;
  std::vector<Point> dots;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const Item& item = items[i];
    if (!item.is_dot) {
      draw_facet(mesh, item.facet, colour, view, svg);
      continue;
    }
    dots.push_back(view.point(item.dot));
    const bool goes_on = i + 1 < items.size() && items[i + 1].is_dot && items[i + 1].colour == item.colour;
    if (goes_on) continue;
    svg.dots(dots, has_few_dots ? LargeDotRadius : DotRadius, item.colour);
    dots.clear();
  }
}

/// Draws a direction as a line from the centre to the hemisphere, with a name at its end.
void draw_direction(const Vec3f& direction, std::string_view name, std::string_view dashes,
                    const HemisphereView& view, plot::Svg& svg) {
  svg.line(view.point(Vec3f(0)), view.point(LongestRadius * direction), {"#333", 1, dashes});
  svg.text(view.point(LongestRadius * direction) + Point(0, -5), name, {11, "#333", plot::Anchor::Middle, 0});
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
  scale_ = std::min(place.width / 2.3, place.height / (below + 1.25));
  centre_ = {place.corner.x + place.width / 2, place.corner.y + place.height - scale_ * (below + 0.06)};
}

Point HemisphereView::point(const Vec3f& position) const {
  return {centre_.x + scale_ * position.dot(right_), centre_.y - scale_ * position.dot(up_)};
}

Vec3f SampledLobe::position(const Vec3f& direction, double value) const {
  return direction *
         std::min(LongestRadius, static_cast<float>(plot::lobe_radius(value, unit_, is_logarithmic_)));
}

SampledLobe::SampledLobe(const reflectance::Brdf& brdf, const Vec3f& u, const plot::LobeStyle& style,
                         std::vector<SampleCloud> clouds, const std::function<bool()>& is_stopped)
    : u_(u),
      is_logarithmic_(style.is_logarithmic),
      clouds_(std::move(clouds)),
      mesh_(plot::lobe_mesh(brdf, u, style, Grid, is_stopped)) {
  for (const SampleCloud& cloud : clouds_) {
    for (const double value : cloud.values) unit_ = std::max(unit_, value);
  }
  if (!(unit_ > 0)) unit_ = mesh_.peak;
  for (std::size_t i = 0; i < mesh_.positions.size(); ++i)
    mesh_.positions[i] = position(mesh_.directions[i], mesh_.values[i]);
}

void SampledLobe::draw(const HemisphereView& view, plot::Svg& svg) const {
  draw_surface(view, svg);
  std::vector<Item> items;
  if (mesh_.peak > 0) add_facets(mesh_, view, items);
  for (const SampleCloud& cloud : clouds_) {
    for (std::size_t i = 0; i < cloud.directions.size(); ++i) {
      const Vec3f at = position(cloud.directions[i], cloud.values[i]);
      items.push_back({view.nearness(at) + DotLead, 0, true, at, cloud.colour});
    }
  }
  std::ranges::sort(items, {}, &Item::nearness);
  draw_items(mesh_, items, view, svg);
  draw_direction({0, 0, 1}, "n", "2 3", view, svg);
  draw_direction(u_, "view", "", view, svg);
  const Vec3f mirror = reflectance::mirrored(u_);
  draw_direction(mirror, "mirror", "6 3", view, svg);
  if (mesh_.specular > 0)
    svg.line(view.point(Vec3f(0)), view.point(mirror * static_cast<float>(mesh_.specular)),
             {SpecularColour, 3.5});
}

std::string SampledLobe::scale_text() const {
  std::string text = fmt::format("radius 1 is {:.4g} 1/sr", unit_);
  if (is_logarithmic_) text += ", on a logarithmic scale";
  if (plot::lobe_radius(mesh_.peak, unit_, is_logarithmic_) > LongestRadius)
    text += fmt::format("; cut: the lobe reaches {:.4g}", mesh_.peak);
  if (mesh_.specular > 0)
    text += fmt::format("; blue line: the specular part, {:.3g} %", 100 * mesh_.specular);
  return text;
}

}  // namespace studies
