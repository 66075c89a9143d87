#include "renderer/plot/svg.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <vector>

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

std::string attributes(const Stroke& stroke) {
  std::string text = fmt::format(R"( stroke="{}" stroke-width="{:.4g}")", stroke.colour, stroke.width);
  if (!stroke.dashes.empty()) text += fmt::format(R"( stroke-dasharray="{}")", stroke.dashes);
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

using Handle = std::unique_ptr<RsvgHandle, decltype(&g_object_unref)>;
using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

}  // namespace

Svg::Svg(double width, double height) {
  text_ = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
      "width=\"{0:.6g}\" "
      "height=\"{1:.6g}\" viewBox=\"0 0 {0:.6g} {1:.6g}\" font-family=\"DejaVu Sans, Verdana, sans-serif\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
      width, height);
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
                  colour, 2 * radius);
  for (const Point& centre : centres) text_ += fmt::format("M{:.1f} {:.1f}h0", centre.x, centre.y);
  text_ += "\"/>\n";
}

void Svg::rectangle(const Point& corner, double width, double height, std::string_view colour) {
  text_ += fmt::format("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"{}\"/>\n",
                       corner.x, corner.y, width, height, colour);
}

void Svg::text(const Point& at, std::string_view words, const Lettering& lettering) {
  const std::string turn = lettering.turned == 0 ? std::string()
                                                 : fmt::format(" transform=\"rotate({:.4g} {:.2f} {:.2f})\"",
                                                               lettering.turned, at.x, at.y);
  text_ += fmt::format(
      "<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{:.4g}\" fill=\"{}\" text-anchor=\"{}\"{}>{}</text>\n",
      at.x, at.y, lettering.size, lettering.colour, name_of(lettering.anchor), turn, escaped(words));
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

void Svg::end_clip() { text_ += "</g>\n"; }

std::optional<std::string> to_png(const std::string& svg, double scale) {
  const auto* bytes = reinterpret_cast<const guint8*>(svg.data());
  const Handle handle(rsvg_handle_new_from_data(bytes, svg.size(), nullptr), &g_object_unref);
  if (!handle) return std::nullopt;
  double width = 0;
  double height = 0;
  if (rsvg_handle_get_intrinsic_size_in_pixels(handle.get(), &width, &height) == 0) return std::nullopt;
  const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(width * scale),
                                                   static_cast<int>(height * scale)),
                        &cairo_surface_destroy);
  const Context context(cairo_create(surface.get()), &cairo_destroy);
  const RsvgRectangle viewport = {0, 0, width * scale, height * scale};
  if (rsvg_handle_render_document(handle.get(), context.get(), &viewport, nullptr) == 0) return std::nullopt;
  std::string png;
  if (cairo_surface_write_to_png_stream(surface.get(), append, &png) != CAIRO_STATUS_SUCCESS)
    return std::nullopt;
  return png;
}

bool write_picture(const Svg& svg, const std::string& path, grf::Diagnostics& diagnostics) {
  constexpr double PixelsOfAPng = 2;  // for screens of today
  const std::string extension = grf::lower_case(std::filesystem::path(path).extension().string());
  if (extension == ".svg") return grf::replace_file(path, svg.str(), diagnostics);
  if (extension != ".png") {
    diagnostics.error(grf::whole_file(path), "the picture's name must end in .svg or .png");
    return false;
  }
  const auto png = to_png(svg.str(), PixelsOfAPng);
  if (!png) {
    diagnostics.error(grf::whole_file(path), "the picture could not be rendered as PNG");
    return false;
  }
  return grf::replace_file(path, *png, diagnostics);
}

}  // namespace plot
