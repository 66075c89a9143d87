#include "renderer/studies/subdivision/scheme_comparison.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "grf/wording.h"
#include "grf/write.h"
#include "renderer/parallel/loops.h"
#include "renderer/plot/colour_scale.h"
#include "renderer/reflectance/albedo.h"
#include "renderer/studies/disc_plot.h"
#include "renderer/studies/reflector_cache.h"
#include "renderer/studies/subdivision/figure.h"

namespace studies {
namespace {

using plot::Anchor;
using plot::Point;
using plot::Rectangle;
using reflectance::Vec3f;

constexpr double DiscSide = 206;
constexpr double ColumnWidth = 320;
constexpr double RowHeight = 256;
constexpr double Top = 96;
constexpr std::size_t Columns = 3;

Rectangle place_of(std::size_t index) {
  return {{FigureMargin + ColumnWidth * static_cast<double>(index % Columns),
           Top + 8 + RowHeight * static_cast<double>(index / Columns)},
          DiscSide,
          DiscSide};
}

grf::PdfModel pdf_of(std::string keyword) {
  grf::PdfModel pdf;
  pdf.keyword = std::move(keyword);
  return pdf;
}

grf::PdfModel with(grf::PdfModel pdf, std::string name, grf::Value value) {
  pdf.arguments.push_back({std::move(name), std::move(value), {}});
  return pdf;
}

std::vector<grf::PdfModel> pdfs_of(const SubdivisionSubject& subject) {
  const reflectance::Brdf& brdf = subject.viewed.brdf;
  return {subject.pdf,
          pdf_of("adaptive"),
          with(pdf_of("factored"), "half", reflectance::has_glossy_part(brdf)),
          pdf_of("cascadeCDF"),
          pdf_of("hemisphere"),
          pdf_of("own")};
}

ComparedScheme compared(const grf::PdfModel& pdf, const SubdivisionSubject& subject, double albedo,
                        const StudyContext& context) {
  const ViewedBrdf& viewed = subject.viewed;
  ComparedScheme scheme;
  scheme.name = grf::to_text(pdf);
  scheme.unsupported_reason = unsupported_reason(reflectance::make_scheme(pdf).value(), viewed.brdf);
  if (!scheme.unsupported_reason.empty()) return scheme;
  scheme.reflector = cached_reflector(subject.cache.get(), viewed.identity, viewed.brdf, pdf);
  const DrawnSamples drawn = subject.settings.drawn(*scheme.reflector, viewed.u);
  scheme.weights = statistics_of(drawn, albedo);
  scheme.integrals = subject.tree.integrals(
      [&](const Vec3f& v) { return double(scheme.reflector->pdf(viewed.u, v)); }, context.is_stopped);
  scheme.samples = cell_samples(drawn, *scheme.reflector, viewed.u, subject.tree, scheme.integrals);
  return scheme;
}

std::string memory_text(std::size_t bytes) {
  return bytes == 0 ? "no tables" : "tables " + grf::bytes_text(bytes);
}

/// Returns the mean pdf in a cell of the grid per projected solid angle: even dots mean an even colour.
double pdf_on_disc(const Subdivision& tree, const ComparedScheme& scheme, const Vec3f& v) {
  const std::size_t cell = tree.grid_index(v.x, v.y);
  const double area = tree.grid().area(static_cast<int>(cell) % tree.grid().resolution(),
                                       static_cast<int>(cell) / tree.grid().resolution());
  return area > 0 ? scheme.integrals[cell] / area : 0;
}

void draw_facts(const ComparedScheme& scheme, const Rectangle& place, plot::Svg& svg) {
  const double x = place.corner.x + place.width + 8;
  double y = place.corner.y + 30;
  const auto line = [&](const std::string& name, const std::string& value) {
    svg.text({x, y}, name, {10, "#666", Anchor::Start, 0});
    svg.text({x, y + 14}, value, {12, "#111", Anchor::Start, 0});
    y += 35;
  };
  line("weights, variance", fmt::format("{:.3g}", scheme.weights.variance));
  line("largest weight", fmt::format("{:.3g}", scheme.weights.largest));
  line(fmt::format("chi-square / {}", scheme.samples.fit.degrees),
       fmt::format("{:.4g}", scheme.samples.fit.statistic));
  line("p-value", fmt::format("{:.3g}", scheme.samples.fit.p_value));
  line("rejected", fmt::format("{:.3g} %", 100 * scheme.weights.rejected));
  svg.text({x, place.corner.y + place.height - 2}, memory_text(scheme.reflector->bytes()),
           {10, "#666", Anchor::Start, 0});
}

/// Draws the reason in lines of limited length.
void draw_reason(const std::string& reason, const Rectangle& place, plot::Svg& svg) {
  constexpr std::size_t Longest = 34;
  double y = place.corner.y + 80;
  for (std::size_t from = 0; from < reason.size();) {
    std::size_t length = std::min(Longest, reason.size() - from);
    const std::size_t space = reason.rfind(' ', from + length);
    if (from + length < reason.size() && space != std::string::npos && space > from) length = space - from;
    svg.text({place.corner.x + 14, y}, reason.substr(from, length), {11, "#666", Anchor::Start, 0});
    from += length + 1;
    y += 16;
  }
}

}  // namespace

std::vector<ComparedScheme> compared_schemes(const SubdivisionSubject& subject, const StudyContext& context) {
  constexpr int AlbedoSamples = 4096;
  const reflectance::Reflector own(subject.viewed.brdf, reflectance::OwnScheme());
  const double albedo = reflectance::mean(reflectance::albedo(own, subject.viewed.u, AlbedoSamples));
  const std::vector<grf::PdfModel> pdfs = pdfs_of(subject);
  std::vector<ComparedScheme> schemes(pdfs.size());
  parallel::for_each_index(pdfs.size(), [&](std::size_t i) {
    if (!context.is_stopped || !context.is_stopped())
      schemes[i] = compared(pdfs[i], subject, albedo, context);
  });
  return schemes;
}

void draw_comparison(const SubdivisionSubject& subject, const std::vector<ComparedScheme>& schemes,
                     plot::Svg& svg) {
  std::vector<DiscMap> maps;
  double least = 0;
  double largest = 0;
  for (const ComparedScheme& scheme : schemes) {
    maps.emplace_back(
        [&](const Vec3f& v) { return scheme.reflector ? pdf_on_disc(subject.tree, scheme, v) : 0; });
    if (maps.back().least() > 0)
      least = least > 0 ? std::min(least, maps.back().least()) : maps.back().least();
    largest = std::max(largest, maps.back().largest());
  }
  const plot::ColourScale scale(least, largest);
  draw_subdivision_header(subject,
                          fmt::format("{:.0f} samples by each scheme, and its pdf per projected solid angle",
                                      subject.settings.count),
                          svg);
  for (std::size_t i = 0; i < schemes.size(); ++i) {
    const Rectangle place = place_of(i);
    svg.text({place.corner.x, place.corner.y - 10}, schemes[i].name,
             {plot::fitting_size(13, schemes[i].name, ColumnWidth - 20), "#111", Anchor::Start, 0});
    if (!schemes[i].reflector) {
      draw_reason("cannot sample this BRDF: " + schemes[i].unsupported_reason, place, svg);
      continue;
    }
    draw(maps[i], scale, place, svg);
    std::vector<Vec3f> directions;
    for (const SampledPoint& point : schemes[i].samples.points) directions.push_back(point.direction);
    draw_directions(directions, place, SampleColour, svg);
    mark_view(subject.viewed.u, place, svg);
    draw_facts(schemes[i], place, svg);
  }
  if (subject.settings.pattern == SubdivisionSettings::Sobol)
    svg.text(
        {svg.width() - FigureMargin, svg.height() - 8},
        "The samples are Sobol' points, more even than random ones: only a wrong pdf has a small p-value.",
        {10, "#666", Anchor::End, 0});
  const double bar = FigureMargin + ColumnWidth * Columns + 4;
  svg.text({bar, Top + 2}, "pdf", {11, "#333", Anchor::Start, 0});
  draw(scale, Rectangle{{bar, Top + 14}, 12, RowHeight + DiscSide - 12}, svg);
}

std::string described_scheme(const SubdivisionSubject& subject, const std::vector<ComparedScheme>& schemes,
                             const Point& at) {
  for (std::size_t i = 0; i < schemes.size(); ++i) {
    const Rectangle place = place_of(i);
    const double x = 2 * (at.x - place.corner.x) / place.width - 1;
    const double y = 1 - 2 * (at.y - place.corner.y) / place.height;
    if (!schemes[i].reflector || !(x * x + y * y < 1)) continue;
    const Vec3f v(Imath::V3d(x, y, std::sqrt(1 - x * x - y * y)));
    const double f = reflectance::mean(reflectance::evaluate(subject.viewed.brdf, subject.viewed.u, v));
    return fmt::format(
        "{}: \u03B8 = {:.4g}\u00B0, \u03C6 = {:.4g}\u00B0: pdf {:.4g} 1/sr, f cos / albedo {:.4g} 1/sr",
        schemes[i].name, std::acos(v.z) / Degree, std::atan2(v.y, v.x) / Degree,
        schemes[i].reflector->pdf(subject.viewed.u, v), f * v.z / subject.tree.integral());
  }
  return {};
}

}  // namespace studies
