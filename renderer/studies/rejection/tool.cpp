#include "renderer/studies/rejection/tool.h"

#include <algorithm>

#include "grf/keywords.h"
#include "renderer/studies/rejection/density.h"
#include "renderer/studies/rejection/settings.h"

namespace studies {
namespace {

std::optional<Study> make_study(const ToolState& state, const StudyContext& context,
                                grf::Diagnostics& diagnostics) {
  const auto settings = reflectance::make<RejectionToolSettings>(state.settings);
  return grf::same_keyword(state.distribution->keyword, BrdfView::table().keyword)
             ? disc_study(state, settings, context, diagnostics)
             : interval_study(state, settings, context, diagnostics);
}

/// Adds to a parameter of a model, within its range.
void add_to(std::string_view name, double change, const grf::ModelInfo& info, grf::Model& model) {
  const grf::ParameterInfo& parameter = *info.find(name);
  const grf::Argument* argument = grf::find_argument(model, parameter);
  const auto* number = argument != nullptr ? std::get_if<float>(&argument->value) : nullptr;
  const double before = number != nullptr ? *number : parameter.default_value;
  set_value(model, name,
            static_cast<float>(std::clamp<double>(before + change, parameter.minimum, parameter.maximum)));
}

/// Turns the view of the BRDF, so that its place on the disc follows the pointer.
void turn(ToolState& state, double azimuth, double elevation) {
  const grf::ModelInfo info = reflectance::info_of<BrdfView>();
  if (!grf::same_keyword(state.distribution->keyword, info.keyword)) return;
  add_to("theta", -azimuth, info, *state.distribution);
  add_to("phi", -elevation, info, *state.distribution);
}

}  // namespace

reflectance::ModelTable<RejectionToolSettings> RejectionToolSettings::table() {
  using Self = RejectionToolSettings;
  using grf::ParameterScale;
  using reflectance::in_unit;
  using reflectance::number_parameter;
  using reflectance::whole;
  using reflectance::word_parameter;
  return {
      .keyword = "rejection",
      .title = "Rejection sampling",
      .parameters = {whole(number_parameter(&Self::samples, "samples", 10, 50000,
                                            "accepted samples that are wanted", ParameterScale::Logarithmic)),
                     word_parameter(
                         &Self::bound, "bound", {"exact", "grid", "hand"},
                         "the exact maximum, the largest value on a grid (which is no bound), or factor "
                         "times the exact maximum"),
                     number_parameter(&Self::factor, "factor", 0.3F, 3,
                                      "bound=hand: the bound over the exact maximum; below 1 it is too low",
                                      ParameterScale::Logarithmic),
                     whole(number_parameter(
                         &Self::cells, "cells", 1, 400,
                         "cells of the grid, along an edge for a BRDF, whose quadtree is made from it",
                         ParameterScale::Logarithmic)),
                     in_unit("%", number_parameter(&Self::tail, "tail", 1e-4F, 5,
                                                   "probability that is cut off at each unbounded end of a "
                                                   "distribution",
                                                   ParameterScale::Logarithmic)),
                     word_parameter(
                         &Self::region, "region", {"disc", "square"},
                         "brdf: tries are uniform on the disc, or as in the renderer on the square around "
                         "it"),
                     number_parameter(&Self::nmax, "nmax", 1.001F, 100,
                                      "mean number of tries that a part of the subdivision may need",
                                      ParameterScale::Logarithmic),
                     whole(number_parameter(&Self::seed, "seed", 0, 1e6F, "seed of the random numbers"))},
      .description =
          "Samples a statistical distribution, or f cos of a BRDF, by rejection: which tries are accepted "
          "under a bound, how many, and whether the samples have the right density. A subdivision with a "
          "bound for each part, the thesis' quadtree, shows what it saves."};
}

reflectance::ModelTable<BrdfView> BrdfView::table() {
  using Self = BrdfView;
  using reflectance::in_unit;
  using reflectance::number_parameter;
  return {.keyword = "brdf",
          .title = "f cos of the BRDF",
          .parameters = {in_unit("deg", number_parameter(&Self::theta, "theta", 0, 89.5F,
                                                         "angle of the view from the normal")),
                         in_unit("deg", number_parameter(&Self::phi, "phi", -180, 180,
                                                         "azimuth of the view from the x axis"))},
          .description = "The BRDF times the cosine, over the directions of light, for a view."};
}

StudyTool rejection_tool() {
  StudyTool tool;
  tool.settings = reflectance::info_of<RejectionToolSettings>();
  tool.distributions = {reflectance::info_of<BrdfView>()};
  for (grf::ModelInfo& info : density_infos()) tool.distributions.push_back(std::move(info));
  tool.brdfs = 1;
  tool.initial.settings.keyword = tool.settings.keyword;
  tool.initial.distribution.emplace().keyword = tool.distributions.front().keyword;
  grf::BrdfModel brdf;
  brdf.keyword = "ward";
  tool.initial.brdfs = {brdf};
  tool.animated = "samples";
  tool.turn = turn;
  tool.make = make_study;
  return tool;
}

}  // namespace studies
