// Documents get vector graphics: SVG as text, which is also converted to PNG and PDF.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

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

/// Returns the font size, at most `size`, at which words fit a width, with room to spare for wide letters.
double fitting_size(double size, std::string_view words, double width);

/// What a document is shown on. For a dark screen, greys are inverted, and dark lines lightened.
enum class Paper { White, Dark };

/// An SVG document under construction, in pixels from the upper left corner.
class Svg {
 public:
  Svg(double width, double height, Paper paper = Paper::White);

  double width() const { return width_; }
  double height() const { return height_; }
  /// Returns a colour as it is on this paper, sRGB-encoded: for white the background's, for black the text's.
  grf::Colour shaded(const grf::Colour& encoded) const;

  void line(const Point& from, const Point& to, const Stroke& stroke);
  void polyline(std::span<const Point> points, const Stroke& stroke);
  void circle(const Point& centre, double radius, const Stroke& stroke);
  /// Draws dots of equal size and colour, in one element.
  void dots(std::span<const Point> centres, double radius, std::string_view colour);
  /// Fills a polygon; a stroke of its own colour hides the seams to polygons beside it.
  void polygon(std::span<const Point> corners, std::string_view fill, double stroke_width);
  void rectangle(const Point& corner, double width, double height, std::string_view colour);
  void text(const Point& at, std::string_view words, const Lettering& lettering);
  void image(const Point& corner, double width, double height, std::string_view png);

  // Clips what is drawn until `end_clip` to a rectangle or a circle.
  void begin_clip(const Point& corner, double width, double height);
  void begin_clip(const Point& centre, double radius);
  void end_clip();

  /// Returns the whole document.
  std::string str() const { return text_ + "</svg>\n"; }

 private:
  std::string fill_of(std::string_view colour) const;
  std::string line_of(std::string_view colour) const;
  std::string attributes(const Stroke& stroke) const;

  double width_;
  double height_;
  Paper paper_;
  std::string text_;
  int clips_ = 0;
};

/// Formats a colour as `#rrggbb`.
std::string hexadecimal(const grf::Colour& encoded);
/// Parses `#rgb` or `#rrggbb`; nothing for other colours.
std::optional<grf::Colour> colour_of(std::string_view hexadecimal);

/// A rendered picture: rows from the top, sRGB-encoded, 0xffRRGGBB each.
struct Bitmap {
  int width = 0;
  int height = 0;
  std::vector<std::uint32_t> pixels;
};

/// Renders at so many pixels per unit; nothing if that fails.
std::optional<Bitmap> to_bitmap(const std::string& svg, double scale);
/// Renders a PNG at so many pixels per unit; nothing if that fails.
std::optional<std::string> to_png(const std::string& svg, double scale);
/// Converts to a PDF of one page, with one unit as a point of print; nothing if that fails.
std::optional<std::string> to_pdf(const std::string& svg);

/// Writes the picture to a file as SVG, PNG or PDF, by the extension of its name.
bool write_picture(const Svg& svg, const std::string& path, grf::Diagnostics& diagnostics);

}  // namespace plot
