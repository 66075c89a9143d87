#include "renderer/studies/disc_plot.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "grf/srgb.h"
#include "renderer/image/encoders.h"
#include "renderer/reflectance/geometry.h"

namespace studies {
namespace {

using grf::Colour;
using plot::Point;
using reflectance::Vec3f;

constexpr int Subpixels = 2;  // along a side

DiscMap::Pixel pixel_at(int column, int row, const std::function<double(const Vec3f&)>& function) {
  double sum = 0;
  int inside = 0;
  for (int k = 0; k < Subpixels * Subpixels; ++k) {
    const auto place = [](int pixel, int subpixel) {
      return 2 * (static_cast<float>(pixel) + (static_cast<float>(subpixel) + 0.5F) / Subpixels) /
                 DiscMap::Side -
             1;
    };
    const float x = place(column, k % Subpixels);
    const float y = -place(row, k / Subpixels);
    const float z2 = 1 - x * x - y * y;
    if (z2 <= 0) continue;
    sum += function(Vec3f(x, y, std::sqrt(z2)));
    ++inside;
  }
  if (inside == 0) return {};
  return {static_cast<float>(sum / inside), static_cast<float>(inside) / (Subpixels * Subpixels)};
}

}  // namespace

Point point_on_disc(double x, double y, const plot::Rectangle& place) {
  return place.corner + Point((1 + x) / 2 * place.width, (1 - y) / 2 * place.height);
}

DiscMap::DiscMap(const std::function<double(const Vec3f&)>& function) {
  pixels_.reserve(static_cast<std::size_t>(Side) * Side);
  for (int i = 0; i < Side * Side; ++i) {
    const Pixel pixel = pixel_at(i % Side, i / Side, function);
    pixels_.push_back(pixel);
    if (!(pixel.value > 0)) continue;
    least_ = least_ > 0 ? std::min<double>(least_, pixel.value) : pixel.value;
    largest_ = std::max<double>(largest_, pixel.value);
  }
}

void draw(const DiscMap& map, const plot::ColourScale& scale, const plot::Rectangle& place, plot::Svg& svg) {
  image::Image image{DiscMap::Side, DiscMap::Side, {}};
  const Colour background = grf::srgb_decoded(svg.shaded(grf::Colour(1)));
  for (const DiscMap::Pixel& pixel : map.pixels()) {
    const Colour colour = grf::srgb_decoded(scale.colour(pixel.value));
    image.pixels.push_back(colour * pixel.coverage + background * (1 - pixel.coverage));
  }
  svg.image(place.corner, place.width, place.height, image::encode_png({image}));
  const Point centre = place.corner + Point(place.width, place.height) / 2;
  for (const double degrees : {30.0, 60.0}) {
    svg.circle(centre, place.width / 2 * std::sin(degrees * std::numbers::pi / 180), {"#999", 0.5, "2 3"});
  }
  svg.circle(centre, place.width / 2, {"#888", 1});
}

void draw_directions(std::span<const Vec3f> directions, const plot::Rectangle& place, std::string_view colour,
                     plot::Svg& svg) {
  constexpr double Radius = 0.9;
  std::vector<Point> points;
  for (const Vec3f& v : directions) points.push_back(point_on_disc(v.x, v.y, place));
  svg.dots(points, Radius, colour);
}

void mark_view(const Vec3f& u, const plot::Rectangle& place, plot::Svg& svg) {
  const Point centre = point_on_disc(u.x, u.y, place);
  svg.circle(centre, 4, {"#fff", 3});
  svg.circle(centre, 4, {"#111", 1.2});
}

}  // namespace studies
