#include "renderer/studies/environment/viewer.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include <fmt/format.h>

#include "renderer/reflectance/brdf.h"
#include "renderer/reflectance/brdf_instance.h"
#include "renderer/studies/angles.h"
#include "renderer/studies/environment/figure.h"
#include "renderer/studies/fit_samples.h"
#include "renderer/studies/reflector_cache.h"

namespace studies {
namespace {

using plot::Point;
using reflectance::mean;
using reflectance::Rgb;
using reflectance::Vec3f;

/// Returns the map's direction at a polar angle from y, and an azimuth from x towards -z.
Vec3f direction_under_y(double theta, double azimuth) {
  const Vec3f z_up = direction_of({theta * Degree, azimuth * Degree});
  return {z_up.x, z_up.z, -z_up.y};
}

std::optional<LitSurface> lit_surface(const ToolState& state, const EnvironmentSettings& settings,
                                      const StudyContext& context, grf::Diagnostics& diagnostics) {
  const auto brdf = reflectance::make_brdf(state.brdfs.front(), diagnostics, state.definitions);
  const auto scheme =
      brdf ? reflectance::make_scheme(state.pdfs.front(), *brdf, state.brdfs.front().keyword, diagnostics)
           : std::nullopt;
  if (!scheme) return std::nullopt;
  auto environment = open_environment(state, context.cache.get(), diagnostics);
  if (!environment) return std::nullopt;
  auto reflector = cached_reflector(context.cache.get(), identity_of(state.brdfs.front(), state.definitions),
                                    *brdf, state.pdfs.front());
  if (!reflector->has_nonspecular_part()) {
    diagnostics.error(state.brdfs.front().location,
                      fmt::format("'{}' reflects into the mirror direction only: all candidates would be the "
                                  "same, and the renderer does not resample them",
                                  state.brdfs.front().keyword));
    return std::nullopt;
  }
  return LitSurface{std::move(environment), std::move(reflector),
                    reflectance::Frame(direction_under_y(settings.tilt, settings.heading)),
                    direction_of({settings.theta * Degree, settings.phi * Degree})};
}

std::string summary_of(const EnvironmentResult& result) {
  return fmt::format(
      "{:.4g} of {} candidates are effective; the reflected radiance is {:.4g} by resampling and {:.4g} by "
      "quadrature, {:+.3g} %.",
      result.light.effective_candidates(), result.light.candidates.size(), mean(result.light.estimate),
      mean(result.reflected), 100 * result.relative_error());
}

std::string csv_of(const EnvironmentResult& result) {
  std::string text = "candidate,x,y,z,map_x,map_y,map_z,red,green,blue,weight,pdf,specular,chosen\n";
  for (std::size_t i = 0; i < result.light.candidates.size(); ++i) {
    const Candidate& candidate = result.light.candidates[i];
    const Vec3f& v = candidate.v;
    const Vec3f direction = result.to_map(v);
    const Rgb& rgb = candidate.estimate;
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", i, v.x, v.y, v.z, direction.x,
                        direction.y, direction.z, rgb.x, rgb.y, rgb.z, candidate.weight(), candidate.pdf,
                        candidate.is_specular ? 1 : 0, candidate.copies);
  }
  return text;
}

std::string fit_text_of(const EnvironmentResult& result) {
  std::vector<reflectance::ScatterSample> samples;
  for (const Candidate& candidate : result.light.candidates) {
    if (candidate.copies > 0)
      samples.push_back({candidate.v, candidate.estimate, candidate.pdf, candidate.is_specular});
  }
  const Angles view = {result.settings.theta * Degree, result.settings.phi * Degree};
  return plot::to_text(fit_of(result.model, *result.surface.reflector, view, samples, {}));
}

/// Returns an angle in degrees for people, without the noise of its computation.
double rounded_degrees(double radians) { return std::round(radians / Degree * 100) / 100 + 0.0; }

std::string described(const EnvironmentResult& result, const Point& at) {
  const auto direction = direction_in_figure(result.settings, at);
  if (!direction) return {};
  const DirectionValues values = result.quadrature.at(*direction);
  const Vec3f& d = *direction;
  const Rgb& light = values.radiance;
  std::string text =
      fmt::format("elevation {:.4g}\u00B0, azimuth {:.4g}\u00B0: radiance ({:.4g}, {:.4g}, {:.4g})",
                  rounded_degrees(std::asin(std::clamp(d.y, -1.0F, 1.0F))),
                  rounded_degrees(std::atan2(-d.z, d.x)), light.x, light.y, light.z);
  if (!(result.surface.frame.to_local(d).z > 0)) {
    return text + fmt::format(", below the surface; density of the map {:.4g}, for this normal {:.4g} 1/sr",
                              values.map, values.warps);
  }
  text += fmt::format(
      ", f cos {:.4g}; densities in 1/sr: BRDF {:.4g}, map {:.4g}, map for this normal {:.4g}, product "
      "{:.4g}, "
      "scheme {:.4g}",
      mean(values.f_cos), values.brdf, values.map, values.warps, values.product, values.scheme);
  if (values.scheme > 0) text += fmt::format("; product over scheme {:.4g}", values.product / values.scheme);
  return text;
}

std::optional<Study> make_study(const ToolState& state, const StudyContext& context,
                                grf::Diagnostics& diagnostics) {
  const auto settings = reflectance::make<EnvironmentSettings>(state.settings);
  const reflectance::Resampling counts = settings.counts();
  if (counts.chosen > counts.candidates) {
    diagnostics.error(state.settings.location,
                      fmt::format("M = {} samples cannot be chosen from N = {} candidates: M is at most N",
                                  counts.chosen, counts.candidates));
    return std::nullopt;
  }
  auto surface = lit_surface(state, settings, context, diagnostics);
  if (!surface) return std::nullopt;
  const auto result = std::make_shared<EnvironmentResult>(settings, state.brdfs.front(), std::move(*surface),
                                                          context.is_stopped);
  Study study{environment_figure(*result, context.paper), summary_of(*result), csv_of(*result),
              fit_text_of(*result)};
  study.describe = [result](const Point& point) { return described(*result, point); };
  return study;
}

}  // namespace

EnvironmentResult::EnvironmentResult(const EnvironmentSettings& asked_for, const grf::BrdfModel& brdf,
                                     LitSurface lit, const std::function<bool()>& is_stopped)
    : settings(asked_for),
      model(brdf),
      surface(std::move(lit)),
      quadrature(surface, is_stopped),
      light(resample(surface, settings.counts(), static_cast<std::uint32_t>(std::lround(settings.seed)))) {
  const Rgb specular = reflectance::specular_weight(surface.reflector->brdf(), surface.u);
  const Vec3f mirror = to_map(reflectance::mirrored(surface.u));
  albedo = quadrature.albedo() + specular;
  reflected = quadrature.reflected() + specular * surface.map().radiance(mirror);
  if (settings.deviations) {
    deviations =
        measure_deviations(surface, settings.visible_directions(), {{4, 16, 64, 256, 1024}, {1, 4, 16, 64}},
                           static_cast<std::uint32_t>(std::lround(settings.seed)), is_stopped);
  }
}

double EnvironmentResult::relative_error() const {
  const double expected = mean(reflected);
  return expected > 0 ? (mean(light.estimate) - expected) / expected : 0;
}

StudyTool environment_viewer_tool() {
  StudyTool tool;
  tool.settings = reflectance::info_of<EnvironmentSettings>();
  tool.initial.settings.keyword = tool.settings.keyword;
  grf::BrdfModel brdf;
  brdf.keyword = "ward";
  brdf.arguments = {{"sx", 0.2F, {}}, {"ks", 0.5F, {}}, {"kd", 0.3F, {}}};
  tool.initial.brdfs.push_back(brdf);
  grf::PdfModel pdf;
  pdf.keyword = "auto";
  tool.initial.pdfs.push_back(pdf);
  tool.brdfs = 1;
  tool.pdfs = 1;
  tool.files = "hdr exr pfm png jpg tga webp";
  tool.azimuth = "azimuth";
  tool.elevation = "elevation";
  tool.make = make_study;
  return tool;
}

}  // namespace studies
