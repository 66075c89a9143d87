// Vector graphics for documents: SVG as text, and its conversion to PNG.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "grf/diagnostics.h"
#include "grf/math.h"

namespace plot {

using Point = grf::Vec2d;

struct Stroke {
  std::string_view colour = "#333";
  double width = 1;
  std::string_view dashes = {};  ///< as in `stroke-dasharray`; empty: solid
};

enum class Anchor { Start, Middle, End };

struct Lettering {
  double size = 12;
  std::string_view colour = "#333";
  Anchor anchor = Anchor::Start;
  double turned = 0;  ///< rotation in degrees, clockwise
};

/// An SVG document under construction, in pixels from the upper left corner, on white.
class Svg {
 public:
  Svg(double width, double height);

  void line(const Point& from, const Point& to, const Stroke& stroke);
  void polyline(std::span<const Point> points, const Stroke& stroke);
  void circle(const Point& centre, double radius, const Stroke& stroke);
  /// Draws dots of equal size and colour, in one element.
  void dots(std::span<const Point> centres, double radius, std::string_view colour);
  void rectangle(const Point& corner, double width, double height, std::string_view colour);
  void text(const Point& at, std::string_view words, const Lettering& lettering);
  void image(const Point& corner, double width, double height, std::string_view png);

  // Clips what is drawn between the two calls to the rectangle.
  void begin_clip(const Point& corner, double width, double height);
  void end_clip();

  /// Returns the whole document.
  std::string str() const { return text_ + "</svg>\n"; }

 private:
  std::string text_;
  int clips_ = 0;
};

/// Renders a PNG at so many pixels per unit; nothing if that fails.
std::optional<std::string> to_png(const std::string& svg, double scale);

/// Writes the picture to a file as SVG or, for names ending in `.png`, as PNG.
bool write_picture(const Svg& svg, const std::string& path, grf::Diagnostics& diagnostics);

}  // namespace plot
