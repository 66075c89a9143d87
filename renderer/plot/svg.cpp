#include "renderer/plot/svg.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <memory>
#include <vector>

#include <cairo-pdf.h>
#include <cairo.h>
#include <fmt/format.h>
#include <librsvg/rsvg.h>

#include "grf/keywords.h"
#include "grf/text_file.h"

namespace plot {
namespace {

std::string escaped(std::string_view words) {
  std::string text;
  for (const char c : words) {
    if (c == '<') {
      text += "&lt;";
    } else if (c == '>') {
      text += "&gt;";
    } else if (c == '&') {
      text += "&amp;";
    } else if (static_cast<unsigned char>(c) < 0x20) {
      text += ' ';  // XML does not allow most of them
    } else {
      text += c;
    }
  }
  return text;
}

std::string_view name_of(Anchor anchor) {
  switch (anchor) {
    case Anchor::Middle:
      return "middle";
    case Anchor::End:
      return "end";
    case Anchor::Start:
      break;
  }
  return "start";
}

std::string base64(std::string_view bytes) {
  gchar* encoded = g_base64_encode(reinterpret_cast<const guchar*>(bytes.data()), bytes.size());
  std::string text = encoded;
  g_free(encoded);
  return text;
}

cairo_status_t append(void* text, const unsigned char* bytes, unsigned size) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), size);
  return CAIRO_STATUS_SUCCESS;
}

/// Returns the distance to the segment, not the line, as a polyline may pass the ends and come back.
double distance_to_segment(const Point& point, const Point& from, const Point& to) {
  const Point along = to - from;
  const double length2 = along.length2();
  const double place = length2 > 0 ? std::clamp(along.dot(point - from) / length2, 0.0, 1.0) : 0;
  return (from + along * place - point).length();
}

/// Simplifies a polyline within a tolerance too small to see (Douglas and Peucker 1973).
void keep_needed(std::span<const Point> points, std::vector<Point>& kept) {
  constexpr double Unseen = 0.05;  // of a pixel
  if (points.size() < 3) return;
  const auto farthest =
      std::max_element(points.begin() + 1, points.end() - 1, [&](const Point& a, const Point& b) {
        return distance_to_segment(a, points.front(), points.back()) <
               distance_to_segment(b, points.front(), points.back());
      });
  if (distance_to_segment(*farthest, points.front(), points.back()) < Unseen) return;
  const auto middle = static_cast<std::size_t>(farthest - points.begin());
  keep_needed(points.first(middle + 1), kept);
  kept.push_back(*farthest);
  keep_needed(points.subspan(middle), kept);
}

std::vector<Point> simplified(std::span<const Point> points) {
  if (points.empty()) return {};
  std::vector<Point> kept = {points.front()};
  keep_needed(points, kept);
  kept.push_back(points.back());
  return kept;
}

// The colours of the editor's dark theme, and how dark lines are made legible on it.
const grf::Colour DarkBackground(0x1f / 255.0F, 0x21 / 255.0F, 0x24 / 255.0F);
const grf::Colour LightText(0.93F);
constexpr float DarkColour = 0.6F;  // the mean of the greatest channel and of all
constexpr float Lightened = 0.3F;   // towards white

using Handle = std::unique_ptr<RsvgHandle, decltype(&g_object_unref)>;
using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

/// An SVG that was parsed, with its size in pixels; the handle is null if that failed.
struct ParsedSvg {
  Handle handle = Handle(nullptr, &g_object_unref);
  double width = 0;
  double height = 0;

  explicit ParsedSvg(const std::string& svg) {
    const auto* bytes = reinterpret_cast<const guint8*>(svg.data());
    handle.reset(rsvg_handle_new_from_data(bytes, svg.size(), nullptr));
    if (handle && rsvg_handle_get_intrinsic_size_in_pixels(handle.get(), &width, &height) == 0)
      handle.reset();
  }

  /// Draws the whole at a scale; returns false if that fails.
  bool render(cairo_t* context, double scale) const {
    const RsvgRectangle viewport = {0, 0, width * scale, height * scale};
    return rsvg_handle_render_document(handle.get(), context, &viewport, nullptr) != 0;
  }
};

/// Renders to an image; null if that fails.
Surface rendered(const std::string& svg, double scale) {
  const ParsedSvg parsed(svg);
  Surface surface(nullptr, &cairo_surface_destroy);
  if (!parsed.handle) return surface;
  surface.reset(cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(parsed.width * scale),
                                           static_cast<int>(parsed.height * scale)));
  const Context context(cairo_create(surface.get()), &cairo_destroy);
  if (!parsed.render(context.get(), scale)) surface.reset();
  return surface;
}

}  // namespace

double fitting_size(double size, std::string_view words, double width) {
  constexpr double LetterWidth = 0.62;  // of the font size
  return std::min(size, width / (LetterWidth * static_cast<double>(std::max<std::size_t>(1, words.size()))));
}

Svg::Svg(double width, double height, Paper paper) : width_(width), height_(height), paper_(paper) {
  text_ = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
      "width=\"{0:.6g}\" "
      "height=\"{1:.6g}\" viewBox=\"0 0 {0:.6g} {1:.6g}\" font-family=\"DejaVu Sans, Verdana, sans-serif\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"{2}\"/>\n",
      width, height, fill_of("#fff"));
}

grf::Colour Svg::shaded(const grf::Colour& encoded) const {
  const bool is_grey = encoded.x == encoded.y && encoded.y == encoded.z;
  if (paper_ == Paper::White || !is_grey) return encoded;
  return LightText + (DarkBackground - LightText) * encoded.x;
}

std::string Svg::fill_of(std::string_view colour) const {
  const auto encoded = paper_ == Paper::White ? std::nullopt : colour_of(colour);
  return encoded ? hexadecimal(shaded(*encoded)) : std::string(colour);
}

std::string Svg::line_of(std::string_view colour) const {
  const auto encoded = paper_ == Paper::White ? std::nullopt : colour_of(colour);
  if (!encoded) return std::string(colour);
  const grf::Colour shown = shaded(*encoded);
  const float brightness = (std::max({shown.x, shown.y, shown.z}) + (shown.x + shown.y + shown.z) / 3) / 2;
  const bool is_coloured = shown == *encoded;
  return hexadecimal(is_coloured && brightness < DarkColour ? shown + (grf::Colour(1) - shown) * Lightened
                                                            : shown);
}

std::string Svg::attributes(const Stroke& stroke) const {
  std::string text =
      fmt::format(R"( stroke="{}" stroke-width="{:.4g}")", line_of(stroke.colour), stroke.width);
  if (!stroke.dashes.empty()) text += fmt::format(R"( stroke-dasharray="{}")", stroke.dashes);
  return text;
}

void Svg::line(const Point& from, const Point& to, const Stroke& stroke) {
  text_ += fmt::format("<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\"{}/>\n", from.x, from.y,
                       to.x, to.y, attributes(stroke));
}

void Svg::polyline(std::span<const Point> points, const Stroke& stroke) {
  text_ += fmt::format("<polyline fill=\"none\" stroke-linejoin=\"round\"{} points=\"", attributes(stroke));
  for (const Point& point : simplified(points)) text_ += fmt::format("{:.2f},{:.2f} ", point.x, point.y);
  text_ += "\"/>\n";
}

void Svg::circle(const Point& centre, double radius, const Stroke& stroke) {
  text_ += fmt::format("<circle fill=\"none\" cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\"{}/>\n", centre.x,
                       centre.y, radius, attributes(stroke));
}

// Round caps of zero-length strokes take fewer bytes than circles.
void Svg::dots(std::span<const Point> centres, double radius, std::string_view colour) {
  if (centres.empty()) return;
  text_ +=
      fmt::format("<path fill=\"none\" stroke-linecap=\"round\" stroke=\"{}\" stroke-width=\"{:.4g}\" d=\"",
                  line_of(colour), 2 * radius);
  for (const Point& centre : centres) text_ += fmt::format("M{:.1f} {:.1f}h0", centre.x, centre.y);
  text_ += "\"/>\n";
}

void Svg::polygon(std::span<const Point> corners, std::string_view fill, double stroke_width) {
  text_ += fmt::format("<path fill=\"{0}\" stroke=\"{0}\" stroke-width=\"{1:.4g}\" d=\"", fill_of(fill),
                       stroke_width);
  char command = 'M';
  for (const Point& corner : corners) {
    text_ += fmt::format("{}{:.1f} {:.1f}", command, corner.x, corner.y);
    command = 'L';
  }
  text_ += "Z\"/>\n";
}

void Svg::rectangle(const Point& corner, double width, double height, std::string_view colour) {
  text_ += fmt::format("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"{}\"/>\n",
                       corner.x, corner.y, width, height, fill_of(colour));
}

void Svg::text(const Point& at, std::string_view words, const Lettering& lettering) {
  const std::string turn = lettering.turned == 0 ? std::string()
                                                 : fmt::format(" transform=\"rotate({:.4g} {:.2f} {:.2f})\"",
                                                               lettering.turned, at.x, at.y);
  text_ += fmt::format(
      "<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{:.4g}\" fill=\"{}\" text-anchor=\"{}\"{}>{}</text>\n",
      at.x, at.y, lettering.size, line_of(lettering.colour), name_of(lettering.anchor), turn, escaped(words));
}

void Svg::image(const Point& corner, double width, double height, std::string_view png) {
  text_ += fmt::format(
      "<image x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" "
      "xlink:href=\"data:image/png;base64,{}\"/>\n",
      corner.x, corner.y, width, height, base64(png));
}

void Svg::begin_clip(const Point& corner, double width, double height) {
  ++clips_;
  text_ += fmt::format(
      "<clipPath id=\"clip{0}\"><rect x=\"{1:.2f}\" y=\"{2:.2f}\" width=\"{3:.2f}\" height=\"{4:.2f}\"/>"
      "</clipPath>\n<g clip-path=\"url(#clip{0})\">\n",
      clips_, corner.x, corner.y, width, height);
}

void Svg::begin_clip(const Point& centre, double radius) {
  ++clips_;
  text_ += fmt::format(
      "<clipPath id=\"clip{0}\"><circle cx=\"{1:.2f}\" cy=\"{2:.2f}\" r=\"{3:.2f}\"/></clipPath>\n"
      "<g clip-path=\"url(#clip{0})\">\n",
      clips_, centre.x, centre.y, radius);
}

void Svg::end_clip() { text_ += "</g>\n"; }

std::string hexadecimal(const grf::Colour& encoded) {
  const auto byte = [](float channel) { return std::lround(255 * std::clamp(channel, 0.0F, 1.0F)); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(encoded.x), byte(encoded.y), byte(encoded.z));
}

std::optional<grf::Colour> colour_of(std::string_view hexadecimal) {
  const std::size_t digits = hexadecimal.size() == 4 ? 1 : 2;
  if (hexadecimal.size() != 1 + 3 * digits || hexadecimal.front() != '#') return std::nullopt;
  grf::Colour colour;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const char* from = hexadecimal.data() + 1 + channel * digits;
    int value = 0;
    const auto [end, error] = std::from_chars(from, from + digits, value, 16);
    if (error != std::errc() || end != from + digits) return std::nullopt;
    colour[static_cast<int>(channel)] = static_cast<float>(digits == 1 ? 17 * value : value) / 255;
  }
  return colour;
}

std::optional<Bitmap> to_bitmap(const std::string& svg, double scale) {
  const Surface surface = rendered(svg, scale);
  if (!surface) return std::nullopt;
  Bitmap bitmap{
      cairo_image_surface_get_width(surface.get()), cairo_image_surface_get_height(surface.get()), {}};
  const auto width = static_cast<std::size_t>(bitmap.width);
  const auto height = static_cast<std::size_t>(bitmap.height);
  bitmap.pixels.resize(width * height);
  cairo_surface_flush(surface.get());
  const unsigned char* row = cairo_image_surface_get_data(surface.get());
  for (std::size_t y = 0; y < height; ++y, row += cairo_image_surface_get_stride(surface.get())) {
    std::uint32_t* const to = bitmap.pixels.data() + y * width;
    std::memcpy(to, row, width * sizeof(std::uint32_t));
    std::for_each(to, to + width, [](std::uint32_t& pixel) { pixel |= 0xff000000U; });
  }
  return bitmap;
}

std::optional<std::string> to_png(const std::string& svg, double scale) {
  const Surface surface = rendered(svg, scale);
  std::string png;
  if (!surface || cairo_surface_write_to_png_stream(surface.get(), append, &png) != CAIRO_STATUS_SUCCESS)
    return std::nullopt;
  return png;
}

std::optional<std::string> to_pdf(const std::string& svg) {
  const ParsedSvg parsed(svg);
  if (!parsed.handle) return std::nullopt;
  std::string pdf;
  const Surface surface(cairo_pdf_surface_create_for_stream(append, &pdf, parsed.width, parsed.height),
                        &cairo_surface_destroy);
  const Context context(cairo_create(surface.get()), &cairo_destroy);
  const bool is_rendered = parsed.render(context.get(), 1);
  cairo_surface_finish(surface.get());
  if (!is_rendered || cairo_surface_status(surface.get()) != CAIRO_STATUS_SUCCESS) return std::nullopt;
  return pdf;
}

bool write_picture(const Svg& svg, const std::string& path, grf::Diagnostics& diagnostics) {
  constexpr double PixelsOfAPng = 2;  // for screens of today
  const std::string extension = grf::lower_case(std::filesystem::path(path).extension().string());
  if (extension == ".svg") return grf::replace_file(path, svg.str(), diagnostics);
  const bool is_png = extension == ".png";
  if (!is_png && extension != ".pdf") {
    diagnostics.error(grf::whole_file(path), "the picture's name must end in .svg, .png or .pdf");
    return false;
  }
  const auto bytes = is_png ? to_png(svg.str(), PixelsOfAPng) : to_pdf(svg.str());
  if (!bytes) {
    diagnostics.error(grf::whole_file(path),
                      fmt::format("the picture could not be converted to {}", is_png ? "PNG" : "PDF"));
    return false;
  }
  return grf::replace_file(path, *bytes, diagnostics);
}

}  // namespace plot
