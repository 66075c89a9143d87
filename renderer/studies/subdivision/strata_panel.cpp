#include "renderer/studies/subdivision/strata_panel.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "grf/write.h"
#include "renderer/studies/reflector_cache.h"
#include "renderer/transport/sobol.h"

namespace studies {
namespace {

using plot::Anchor;
using plot::Point;
using plot::Rectangle;
using reflectance::Vec2f;

constexpr int Strata = 16;  // along an edge
constexpr int Points = 3;   // of a stratum, along an edge
constexpr double Side = 126;
constexpr double DotRadius = 1.1;

/// A square of the disc's plane that is drawn.
struct Window {
  Point centre = {0, 0};
  double half = 1;
};

/// Points by stratum; those that a scheme rejects are missing.
using PointsOfStrata = std::vector<std::vector<Point>>;

/// Returns the colour of a stratum: its hue changes along x, its lightness along y, and its saturation like a
/// chessboard.
std::string colour_of(int column, int row) {
  const auto fraction = [](int i) { return static_cast<float>(i) / (Strata - 1); };
  const float hue = 5 * fraction(column);  // from red to magenta, in sixths of a turn
  const float saturation = (column + row) % 2 == 0 ? 1.0F : 0.45F;
  const float value = 0.55F + 0.4F * fraction(row);
  const auto channel = [&](float peak) {
    const float away = std::abs(std::remainder(hue - peak, 6.0F));
    return value * (1 - saturation * std::clamp(away - 1, 0.0F, 1.0F));
  };
  return plot::hexadecimal({channel(0), channel(2), channel(4)});
}

/// Maps points of the unit square, a regular pattern in each stratum.
template <class Map>
PointsOfStrata mapped(Map map) {
  PointsOfStrata strata(static_cast<std::size_t>(Strata) * Strata);
  std::uint32_t index = 0;
  for (int i = 0; i < Strata * Strata * Points * Points; ++i) {
    const int column = i % (Strata * Points);
    const int row = i / (Strata * Points);
    const Vec2f xi((static_cast<float>(column) + 0.5F) / (Strata * Points),
                   (static_cast<float>(row) + 0.5F) / (Strata * Points));
    if (const auto point = map(xi, index++))
      strata[static_cast<std::size_t>(row / Points) * static_cast<std::size_t>(Strata) +
             static_cast<std::size_t>(column / Points)]
          .push_back(*point);
  }
  return strata;
}

PointsOfStrata sampled(const reflectance::Scheme& scheme, const ViewedBrdf& viewed) {
  return mapped([&](const Vec2f& xi, std::uint32_t index) -> std::optional<Point> {
    const float choice = transport::sobol_point(index, transport::hash(0, 0)).z;
    const auto sample = reflectance::sample(scheme, viewed.brdf, viewed.u, {xi, choice});
    return sample ? std::optional(Point(sample->direction.x, sample->direction.y)) : std::nullopt;
  });
}

/// Returns a window around nine tenths of the points, at most the disc.
Window window_of(const PointsOfStrata& strata) {
  std::vector<double> xs;
  std::vector<double> ys;
  for (const auto& points : strata) {
    for (const Point& point : points) {
      xs.push_back(point.x);
      ys.push_back(point.y);
    }
  }
  if (xs.empty()) return {};
  const auto range = [](std::vector<double>& values) {
    std::ranges::sort(values);
    return std::pair(values[values.size() / 20], values[values.size() - 1 - values.size() / 20]);
  };
  const auto [x0, x1] = range(xs);
  const auto [y0, y1] = range(ys);
  const double half = std::max({x1 - x0, y1 - y0, 0.01}) / 2 * 1.35;
  if (half > 0.7) return {};
  return {{(x0 + x1) / 2, (y0 + y1) / 2}, half};
}

void draw_square(const PointsOfStrata& strata, const Window& window, const Point& corner, plot::Svg& svg) {
  const auto place = [&](const Point& point) {
    return corner + Point((1 + (point.x - window.centre.x) / window.half) / 2 * Side,
                          (1 - (point.y - window.centre.y) / window.half) / 2 * Side);
  };
  svg.begin_clip(corner, Side, Side);
  for (int i = 0; i < Strata * Strata; ++i) {
    std::vector<Point> dots;
    for (const Point& point : strata[static_cast<std::size_t>(i)]) dots.push_back(place(point));
    svg.dots(dots, DotRadius, colour_of(i % Strata, i / Strata));
  }
  svg.end_clip();
}

void draw_rim(const Window& window, const Point& corner, plot::Svg& svg) {
  const Point centre(-window.centre.x / window.half, window.centre.y / window.half);
  svg.begin_clip(corner, Side, Side);
  svg.circle(corner + (centre + Point(1, 1)) * (Side / 2), Side / 2 / window.half, {"#888", 1});
  svg.end_clip();
}

void draw_frame(const Point& corner, plot::Svg& svg) {
  const Point right(Side, 0);
  const Point down(0, Side);
  svg.polyline(std::array{corner, corner + right, corner + right + down, corner + down, corner},
               {"#bbb", 0.8});
}

}  // namespace

void draw_strata(const SubdivisionSubject& subject, const Rectangle& place, plot::Svg& svg) {
  const double top = place.corner.y + 32;
  const auto corner = [&](int column) {
    return Point(place.corner.x + column * (place.width - Side) / 2, top);
  };
  const auto caption = [&](int column, const std::string& words) {
    svg.text(corner(column) + Point(0, -6), words, {11, "#333", Anchor::Start, 0});
  };
  svg.text(place.corner + Point(0, 6), "Strata of random numbers, and where they go",
           {13, "#111", Anchor::Start, 0});
  caption(0, "16 \u00D7 16 strata");
  // The unit square is the window of the disc's square, so that both are drawn alike.
  const PointsOfStrata square =
      mapped([](const Vec2f& xi, std::uint32_t) { return std::optional(Point(2 * xi.x - 1, 2 * xi.y - 1)); });
  draw_square(square, {{0, 0}, 1}, corner(0), svg);
  draw_frame(corner(0), svg);

  grf::PdfModel warp;
  warp.keyword = "adaptive";
  const auto warp_reflector =
      cached_reflector(subject.cache.get(), subject.viewed.identity, subject.viewed.brdf, warp);
  const PointsOfStrata warped = sampled(warp_reflector->scheme(), subject.viewed);
  const Window window = window_of(warped);
  caption(1, "adaptive mode=warp");
  draw_square(warped, window, corner(1), svg);
  draw_rim(window, corner(1), svg);
  draw_frame(corner(1), svg);
  if (subject.reflector) {
    constexpr std::size_t Longest = 20;
    const std::string name = grf::to_text(subject.pdf);
    caption(2, name.size() <= Longest ? name : "the chosen scheme");
    draw_square(sampled(subject.reflector->scheme(), subject.viewed), window, corner(2), svg);
    draw_rim(window, corner(2), svg);
    draw_frame(corner(2), svg);
  }
  if (window.half < 1)
    svg.text(corner(1) + Point(0, Side + 15), fmt::format("part of the disc, {:.2g} wide", 2 * window.half),
             {11, "#666", Anchor::Start, 0});
}

}  // namespace studies
