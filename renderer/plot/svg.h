// Vector pictures for documents: SVG as text, and PNG of it.
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
  std::string_view dashes = {};  ///< as `stroke-dasharray` has them; empty: none
};

enum class Anchor { Start, Middle, End };

struct Lettering {
  double size = 12;
  std::string_view colour = "#333";
  Anchor anchor = Anchor::Start;
  double turned = 0;  ///< degrees, clockwise
};

/// An SVG picture while it is drawn, in pixels from the upper left corner, on white.
class Svg {
 public:
  Svg(double width, double height);

  void line(const Point& from, const Point& to, const Stroke& stroke);
  void polyline(std::span<const Point> points, const Stroke& stroke);
  void circle(const Point& centre, double radius, const Stroke& stroke);
  /// All alike, in one element.
  void dots(std::span<const Point> centres, double radius, std::string_view colour);
  void rectangle(const Point& corner, double width, double height, std::string_view colour);
  void text(const Point& at, std::string_view words, const Lettering& lettering);
  void image(const Point& corner, double width, double height, std::string_view png);

  // What is drawn between the two calls shows inside the rectangle alone.
  void begin_clip(const Point& corner, double width, double height);
  void end_clip();

  /// The whole document.
  std::string str() const { return text_ + "</svg>\n"; }

 private:
  std::string text_;
  int clips_ = 0;
};

/// A PNG file's bytes, so many pixels to one of the picture; nothing if it cannot be drawn.
std::optional<std::string> to_png(const std::string& svg, double scale);

/// Replaces a file by the picture as SVG or, if its name says so, PNG.
bool write_picture(const Svg& svg, const std::string& path, grf::Diagnostics& diagnostics);

}  // namespace plot
