#include "samples/studies/sampling/measure.h"

#include <cmath>

#include <fmt/format.h>

#include "renderer/parallel/loops.h"

namespace study {
namespace {

using reflectance::Brdf;

void measure_tables(const Brdf& brdf, const Effort& effort, const FitMeter& meter, CaseResult& result) {
  const auto adaptive = [&](const char* mode, int trees) {
    return table_cost(brdf, fmt::format("adaptive nQT={} nAnisoQT=1 {}", trees, mode), effort.builds);
  };
  const std::string reject = fmt::format("mode=reject release=true res={}", effort.resolution);
  result.reject_60 = adaptive(reject.c_str(), 60);
  result.reject_90 = adaptive(reject.c_str(), 90);
  result.warp_60 = adaptive("mode=warp", 60);
  result.warp_90 = adaptive("mode=warp", 90);
  result.tree_bytes = tree_bytes(brdf, effort.resolution);

  const std::string as_printed = scheme_text(result.subject->thesis.factors);
  result.factored = table_cost(brdf, as_printed, effort.builds);
  result.factored_distance = meter.fit_of(Technique(brdf, scheme_of(as_printed))).distance;
  result.found = best_factors(brdf, meter, effort.most_factors);
  result.factored_found = table_cost(brdf, scheme_text(result.found.parameters), effort.builds);
}

std::string scheme_for(TechniqueId id, const Brdf& brdf, const Effort& effort, const FitMeter& meter,
                       const FactorFit& found) {
  switch (id) {
    case Diffuse:
      return "diffuse";
    case Sphere50:
      return "sphere exp=50";
    case SphereBest:
      return fmt::format("sphere exp={}", best_exponent("sphere", brdf, meter));
    case Hemisphere50:
      return "hemisphere exp=50";
    case HemisphereBest:
      return fmt::format("hemisphere exp={}", best_exponent("hemisphere", brdf, meter));
    case Factored:
      return scheme_text(found.parameters);
    case Cascade:
      return "cascadeCDF";
    case Reject:
      return fmt::format("adaptive mode=reject res={}", effort.resolution);
    case Warp:
      return "adaptive mode=warp";
    case Own:
      break;
  }
  return "own";
}

using Settings = std::vector<Setting>;

TechniqueResult measure_technique(const std::string& scheme, const Brdf& brdf, const Effort& effort,
                                  const FitMeter& meter, const Settings& settings) {
  const Technique technique = scheme == "own" ? Technique(brdf) : Technique(brdf, scheme_of(scheme));
  TechniqueResult result;
  result.scheme = scheme;
  result.cosine_fraction = technique.cosine_fraction();
  result.build_seconds = technique.build_seconds();
  result.bytes = technique.bytes();
  result.cost = sample_cost(technique, effort.rounds);
  result.fit = meter.fit_of(technique);
  const std::size_t count = settings.size() * PointNames.size();
  parallel::for_each_index(count, [&](std::size_t i) {
    const std::size_t view = i % settings.size();
    const auto points = static_cast<Points>(i / settings.size());
    result.errors[points][view] = measure_errors(technique, settings[view], points, effort.repeats);
  });
  return result;
}

Settings settings_for(const Brdf& brdf) {
  static const Surroundings surroundings;
  Settings settings;
  for (const float degrees : ViewDegrees) {
    settings.emplace_back(brdf, in_plane_of_views(degrees), degrees, surroundings);
  }
  return settings;
}

}  // namespace

CaseResult measure(const Case& subject, const Effort& effort) {
  const Brdf brdf = brdf_of(subject.brdf);
  const FitMeter meter(brdf);
  CaseResult result;
  result.subject = &subject;
  result.is_glossy = has_glossy_part(brdf);
  measure_tables(brdf, effort, meter, result);
  const Settings settings = settings_for(brdf);
  for (std::size_t i = 0; i < TechniqueNames.size(); ++i) {
    const std::string scheme = scheme_for(static_cast<TechniqueId>(i), brdf, effort, meter, result.found);
    result.techniques[i] = measure_technique(scheme, brdf, effort, meter, settings);
  }
  for (std::size_t light = 0; light < LightCount; ++light) {
    double sum = 0;
    for (const Setting& setting : settings) {
      sum += std::pow(setting.perfect_error(static_cast<Light>(light)), 2);
    }
    result.perfect[light] = std::sqrt(sum / static_cast<double>(settings.size()));
  }
  return result;
}

}  // namespace study
