#include "renderer/studies/subdivision/tool.h"

#include <cmath>
#include <memory>
#include <numbers>

#include <fmt/format.h>

#include "grf/text_file.h"
#include "grf/write.h"
#include "renderer/plot/fit_file.h"
#include "renderer/studies/subdivision/figure.h"
#include "renderer/studies/subdivision/scheme_comparison.h"
#include "renderer/studies/subdivision/subject.h"

namespace studies {
namespace {

constexpr double Width = 1040;
constexpr double Height = 620;

std::string csv_of(const CellSamples& samples) {
  std::string text = "x,y,z,pdf,f\n";
  for (const SampledPoint& point : samples.points) {
    const reflectance::Vec3f& v = point.direction;
    text += fmt::format("{},{},{},{},{}\n", v.x, v.y, v.z, point.pdf, point.f);
  }
  return text;
}

std::string fit_of(const SubdivisionSubject& subject) {
  // A FIT file has no definitions of the terms of a sum.
  if (!subject.viewed.model.terms.empty()) return {};
  plot::FitFile fit;
  fit.brdf = subject.viewed.model;
  // Where the text will be written is not known here.
  if (!fit.brdf.data_file.empty() && fit.brdf.location.file)
    fit.brdf.data_file = grf::path_beside(fit.brdf.location.file->path, fit.brdf.data_file);
  fit.theta = static_cast<float>(subject.viewed.view.theta);
  fit.phi = static_cast<float>(std::remainder(subject.viewed.view.phi, 2 * std::numbers::pi));
  for (const SampledPoint& point : subject.samples.points)
    fit.points.push_back({point.direction, static_cast<float>(point.f)});
  return plot::to_text(fit);
}

std::string summary_of(const SubdivisionSubject& subject) {
  const Subdivision& tree = subject.tree;
  const CellSamples& samples = subject.samples;
  std::string text = fmt::format("{} cells to depth {}, {:.4g} tries per sample; ", tree.cells().size(),
                                 tree.deepest(), tree.mean_tries());
  text += subject.is_file() ? fmt::format("{} directions of {}", samples.points.size(), subject.file)
                            : fmt::format("{} samples by {}, {} rejected", samples.points.size(),
                                          grf::to_text(subject.pdf), samples.rejected);
  return text + fmt::format("; chi-square {:.4g} of {} degrees of freedom, p = {:.3g}.",
                            samples.fit.statistic, samples.fit.degrees, samples.fit.p_value);
}

/// Warns of a number of a sample that there is not.
void check_sample(const SubdivisionSubject& subject, const ToolState& state, grf::Diagnostics& diagnostics) {
  const auto number = static_cast<std::size_t>(std::lround(subject.settings.sample));
  if (number > subject.samples.points.size())
    diagnostics.warning(state.settings.location,
                        fmt::format("there is no sample {}: {} have a direction that is not specular", number,
                                    subject.samples.points.size()));
}

std::optional<Study> make_study(const ToolState& state, const StudyContext& context,
                                grf::Diagnostics& diagnostics) {
  auto made = subdivision_subject(state, context, diagnostics);
  if (!made) return std::nullopt;
  check_sample(*made, state, diagnostics);
  const auto subject = std::make_shared<const SubdivisionSubject>(std::move(*made));
  plot::Svg svg(Width, Height, context.paper);
  Study study{std::move(svg), summary_of(*subject), csv_of(subject->samples), fit_of(*subject)};
  if (subject->settings.panels == SubdivisionSettings::Compare) {
    const auto schemes =
        std::make_shared<const std::vector<ComparedScheme>>(compared_schemes(*subject, context));
    if (context.is_stopped && context.is_stopped()) return study;
    draw_comparison(*subject, *schemes, study.figure);
    study.describe = [subject, schemes](const plot::Point& point) {
      return described_scheme(*subject, *schemes, point);
    };
  } else {
    draw_subdivision(*subject, context, study.figure);
    study.describe = [subject](const plot::Point& point) { return described_cell(*subject, point); };
  }
  return study;
}

}  // namespace

StudyTool subdivision_tool() {
  StudyTool tool;
  tool.settings = reflectance::info_of<SubdivisionSettings>();
  tool.initial.settings.keyword = tool.settings.keyword;
  grf::BrdfModel brdf;
  brdf.keyword = "ward";
  grf::PdfModel pdf;
  pdf.keyword = "adaptive";
  // Few coarse trees are built in the time of a frame.
  pdf.arguments = {{"mode", grf::Word{"reject"}, {}}, {"nQT", 30.0F, {}}, {"res", 200.0F, {}}};
  tool.initial.brdfs = {brdf};
  tool.initial.pdfs = {pdf};
  tool.brdfs = 1;
  tool.pdfs = 1;
  tool.files = "fit";
  tool.azimuth = "azimuth";
  tool.elevation = "elevation";
  tool.animated = "theta";
  tool.make = make_study;
  return tool;
}

}  // namespace studies
