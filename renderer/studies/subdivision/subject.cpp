#include "renderer/studies/subdivision/subject.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "grf/text_file.h"
#include "grf/write.h"
#include "renderer/plot/fit_file.h"
#include "renderer/reflectance/brdf_instance.h"
#include "renderer/studies/reflector_cache.h"

namespace studies {
namespace {

using reflectance::Vec3f;

std::optional<plot::FitFile> read_points(const ToolState::File& file, grf::Diagnostics& diagnostics) {
  const auto text = grf::read_file(file.path, diagnostics, file.location);
  auto fit = text ? plot::read_fit(*text, file.path, diagnostics) : std::nullopt;
  if (!fit) return std::nullopt;
  if (std::abs(fit->theta) < std::numbers::pi / 2) return fit;
  diagnostics.error(
      grf::whole_file(file.path),
      fmt::format("the view's theta, {}, is not above the surface: angles are in radians, below 1.5708",
                  fit->theta));
  return std::nullopt;
}

std::optional<ViewedBrdf> viewed_brdf(const grf::BrdfModel& model,
                                      std::span<const grf::Definition> definitions, const Angles& view,
                                      grf::Diagnostics& diagnostics) {
  auto brdf = reflectance::make_brdf(model, diagnostics, definitions);
  if (!brdf) return std::nullopt;
  if (has_nonspecular_part(*brdf))
    return ViewedBrdf{model, identity_of(model, definitions), std::move(*brdf), view, direction_of(view)};
  diagnostics.error(model.location,
                    fmt::format("'{}' reflects nothing that a tree could show: {}", grf::to_text(model),
                                has_specular_part(*brdf) ? "it is only a mirror" : "it is black"));
  return std::nullopt;
}

Subdivision tree_of(const ViewedBrdf& viewed, const SubdivisionSettings& settings) {
  const auto rounded = [](float value) { return static_cast<int>(std::lround(value)); };
  return Subdivision(viewed.brdf, viewed.view,
                     {settings.nmax, rounded(settings.depth), rounded(settings.resolution)});
}

/// Counts the points in the cells and compares.
void count_in_cells(const Subdivision& tree, double unexpected, CellSamples& samples) {
  samples.counted.assign(tree.cells().size(), 0.0);
  std::size_t outside = samples.rejected + samples.specular;
  for (const SampledPoint& point : samples.points) {
    if (const auto cell = tree.cell_at(point.direction.x, point.direction.y)) {
      samples.counted[*cell] += 1;
    } else {
      ++outside;
    }
  }
  std::vector<double> expected = samples.expected;
  std::vector<double> counted = samples.counted;
  expected.push_back(std::max(0.0, unexpected));
  counted.push_back(static_cast<double>(outside));
  samples.fit = goodness_of_fit(expected, counted);
}

/// Returns the points of a FIT file. They are compared with what they have if they follow f cos: the masses
/// of the tree.
CellSamples samples_of(const plot::FitFile& fit, const ViewedBrdf& viewed, const Subdivision& tree) {
  CellSamples samples;
  std::size_t below = 0;
  for (const plot::FitPoint& point : fit.points) {
    if (!(point.direction.z > 0)) {
      ++below;
      continue;
    }
    const Vec3f v = point.direction.normalized();
    const double f = reflectance::mean(reflectance::evaluate(viewed.brdf, viewed.u, v));
    samples.points.push_back({v, f * v.z / tree.integral(), f});
  }
  const auto count = static_cast<double>(samples.points.size());
  for (const Subdivision::Cell& cell : tree.cells()) samples.expected.push_back(cell.mass * count);
  count_in_cells(tree, 0, samples);
  samples.rejected = below;
  return samples;
}

}  // namespace

CellSamples cell_samples(const DrawnSamples& drawn, const reflectance::Reflector& reflector, const Vec3f& u,
                         const Subdivision& tree, const std::vector<double>& integrals) {
  CellSamples samples;
  samples.rejected = drawn.rejected;
  for (const reflectance::ScatterSample& sample : drawn.samples) {
    if (sample.is_specular) {
      ++samples.specular;
    } else {
      samples.points.push_back(
          {sample.direction, sample.pdf, reflectance::mean(reflector.evaluate(u, sample.direction))});
    }
  }
  const auto count = static_cast<double>(drawn.count());
  samples.expected = tree.sums_over_cells(integrals);
  double unexpected = count;
  for (double& cell : samples.expected) {
    cell *= count;
    unexpected -= cell;
  }
  count_in_cells(tree, unexpected, samples);
  return samples;
}

std::optional<SubdivisionSubject> subdivision_subject(const ToolState& state, const StudyContext& context,
                                                      grf::Diagnostics& diagnostics) {
  const auto settings = reflectance::make<SubdivisionSettings>(state.settings);
  if (state.files.size() > 1) {
    diagnostics.error(state.files[1].location, "'subdivision' shows one FIT file: remove the others");
    return std::nullopt;
  }
  if (!state.files.empty()) {
    const ToolState::File& file = state.files.front();
    const auto fit = read_points(file, diagnostics);
    auto viewed = fit ? viewed_brdf(fit->brdf, {}, {fit->theta, fit->phi}, diagnostics) : std::nullopt;
    if (!viewed) return std::nullopt;
    Subdivision tree = tree_of(*viewed, settings);
    CellSamples samples = samples_of(*fit, *viewed, tree);
    SubdivisionSubject subject{settings, std::move(*viewed), std::move(tree), state.pdfs.front(),
                               grf::file_name(file.path)};
    subject.cache = context.cache;
    subject.samples = std::move(samples);
    const reflectance::Brdf& brdf = subject.viewed.brdf;
    if (unsupported_reason(reflectance::make_scheme(subject.pdf).value(), brdf).empty())
      subject.reflector = cached_reflector(context.cache.get(), subject.viewed.identity, brdf, subject.pdf);
    return subject;
  }
  auto viewed = viewed_brdf(state.brdfs.front(), state.definitions,
                            {settings.theta * Degree, settings.phi * Degree}, diagnostics);
  if (!viewed) return std::nullopt;
  const grf::PdfModel& pdf = state.pdfs.front();
  if (!reflectance::make_scheme(pdf, viewed->brdf, viewed->model.keyword, diagnostics)) return std::nullopt;
  Subdivision tree = tree_of(*viewed, settings);
  SubdivisionSubject subject{settings, std::move(*viewed), std::move(tree), pdf};
  subject.cache = context.cache;
  const Vec3f& u = subject.viewed.u;
  subject.reflector =
      cached_reflector(context.cache.get(), subject.viewed.identity, subject.viewed.brdf, pdf);
  const DrawnSamples drawn = settings.drawn(*subject.reflector, u);
  const auto integrals = subject.tree.integrals(
      [&](const Vec3f& v) { return double(subject.reflector->pdf(u, v)); }, context.is_stopped);
  subject.samples = cell_samples(drawn, *subject.reflector, u, subject.tree, integrals);
  return subject;
}

}  // namespace studies
