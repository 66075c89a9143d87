#include "renderer/options/scheme_model.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "grf/keywords.h"

namespace options {
namespace {

/// An option and the parameters of sampling schemes that it sets, one per value.
struct SchemeParameter {
  std::string_view key;
  std::vector<std::string_view> schemes;
  std::vector<std::string_view> names;  ///< empty: the scheme has no such parameter in a scene
};

const std::vector<SchemeParameter>& scheme_parameters() {
  static const std::vector<SchemeParameter> parameters = {
      {"BPT_Pdf_LobeExponent", {"hemisphere", "sphere"}, {"exp"}},
      {"BPT_Pdf_AnisoNu", {"anisotropic"}, {"nu"}},
      {"BPT_Pdf_AnisoNv", {"anisotropic"}, {"nv"}},
      {"BPT_QT_Precomputed", {"adaptive"}, {"nQT"}},
      {"BPT_QT_Anisotropic", {"adaptive"}, {"nAnisoQT"}},
      {"BPT_QT_avgnmax", {"adaptive"}, {"nmax"}},
      {"BPT_QT_ImgRes", {"adaptive"}, {"res"}},
      {"BPT_QT_release", {"adaptive"}, {"release"}},
      {"BPT_Pdf_Factors_ResU", {"factored"}, {"uTh", "uPh"}},
      {"BPT_Pdf_Factors_ResP", {"factored"}, {"pTh", "pPh"}},
      {"BPT_Pdf_Factors_JK", {"factored"}, {"J", "K"}},
      {"BPT_Pdf_Factors_Half", {"factored"}, {"half"}},
      {"BPT_Pdf_Factors_File", {"factored"}, {}},
      {"BPT_Pdf_CDF_Res", {"cascadeCDF"}, {"nTh", "nPh"}},
      {"BPT_Pdf_CDF_Compress", {"cascadeCDF"}, {"compress"}}};
  return parameters;
}

std::vector<grf::Value> values_of(bool value) { return {value}; }
std::vector<grf::Value> values_of(int value) { return {static_cast<float>(value)}; }
std::vector<grf::Value> values_of(float value) { return {value}; }
std::vector<grf::Value> values_of(const IntegerPair& value) {
  return {static_cast<float>(value.first), static_cast<float>(value.second)};
}

/// Returns the values of an option of a scheme; empty if it was not given.
std::vector<grf::Value> given_values(const RenderOptions& options, const OptionInfo& info) {
  return std::visit(
      [&](const auto& value) {
        const auto& field = options.*value.field;
        if constexpr (requires { values_of(*field); }) {
          return field ? values_of(*field) : std::vector<grf::Value>();
        } else {
          return std::vector<grf::Value>();
        }
      },
      info.value);
}

/// Returns the GRF keyword of a scheme's name in OP files.
std::string keyword_of(std::string_view name) {
  if (grf::same_keyword(name, "Disk")) return "adaptive";
  return grf::same_keyword(name, "CascadeCDF") ? "cascadeCDF" : grf::lower_case(name);
}

bool is_for(const SchemeParameter& parameter, std::string_view keyword) {
  return std::any_of(parameter.schemes.begin(), parameter.schemes.end(),
                     [&](std::string_view scheme) { return grf::same_keyword(scheme, keyword); });
}

bool is_naive(const RenderOptions& options) { return options.integrator == "naive"; }

/// Returns why an option has no effect; empty if it has one.
struct Rule {
  std::string_view key;
  std::string_view (*why)(const RenderOptions& options);
};

std::string_view why_no_places(const RenderOptions& options) {
  return is_naive(options) ? "" : "the integrator 'path' places its samples itself";
}

std::string_view why_no_resampling(const RenderOptions& options) {
  if (options.environment.empty()) {
    return options.projection == "backplate" ? "a backplate lights nothing" : "no BPT_EM_Background is given";
  }
  if (options.projection == "backplate") return "a backplate lights nothing";
  return is_naive(options) ? "the integrator 'naive' does not sample lights" : "";
}

constexpr std::array Rules = {
    Rule{"BPT_Samples",
         [](const RenderOptions& options) -> std::string_view {
           return is_naive(options) ? "the integrator 'naive' takes Pixel_SampleRes x NSecRaysRoot^2" : "";
         }},
    Rule{"BPT_Branches",
         [](const RenderOptions& options) -> std::string_view {
           return is_naive(options) ? "the integrator 'naive' takes NSecRaysRoot^2" : "";
         }},
    Rule{"BPT_Irradiance",
         [](const RenderOptions& options) -> std::string_view {
           return is_naive(options) ? "the integrator 'naive' does not use baked irradiance" : "";
         }},
    Rule{"BPT_Pixel_Radial", why_no_places},
    Rule{"BPT_Pixel_Random", why_no_places},
    Rule{"BPT_EM_Projection",
         [](const RenderOptions& options) -> std::string_view {
           return options.environment.empty() ? "no BPT_EM_Background is given" : "";
         }},
    Rule{"BPT_RIS", why_no_resampling},
};

/// Options that ray casting ignores: its paths end at the first hit.
constexpr std::array UnusedByRayCasting = {"BPT_Integrator",   "BPT_Depth",           "BPT_Branches",
                                           "BPT_Samples",      "BPT_Pixel_SampleRes", "BPT_Pixel_Random",
                                           "BPT_Pixel_Radial", "BPT_RE_NSecRaysRoot"};

}  // namespace

std::optional<grf::PdfModel> scheme_model(const RenderOptions& options) {
  if (options.scheme.empty()) return std::nullopt;
  grf::PdfModel model;
  model.keyword = keyword_of(options.scheme);
  model.location = options.locations.of("BPT_Pdf_Name");
  for (const SchemeParameter& parameter : scheme_parameters()) {
    if (!is_for(parameter, model.keyword) || parameter.names.empty()) continue;
    const std::vector<grf::Value> values = given_values(options, *find_option(parameter.key));
    for (std::size_t i = 0; i < values.size(); ++i) {
      model.arguments.push_back(
          {std::string(parameter.names[i]), values[i], options.locations.of(parameter.key)});
    }
  }
  return model;
}

std::optional<std::string> why_unused(const RenderOptions& options, const OptionInfo& option) {
  for (const SchemeParameter& parameter : scheme_parameters()) {
    if (parameter.key != option.key) continue;
    if (options.scheme.empty()) {
      return "no BPT_Pdf_Name is given, so the parameters of the scene's schemes apply";
    }
    const std::string keyword = keyword_of(options.scheme);
    if (!is_for(parameter, keyword)) return fmt::format("the scheme '{}' does not use it", keyword);
  }
  if (options.ray_casting && std::find(UnusedByRayCasting.begin(), UnusedByRayCasting.end(), option.key) !=
                                 UnusedByRayCasting.end()) {
    return "BPT_RayCasting traces one ray per pixel";
  }
  for (const Rule& rule : Rules) {
    if (rule.key == option.key && !rule.why(options).empty()) return std::string(rule.why(options));
  }
  return std::nullopt;
}

void warn_of_unused_options(const RenderOptions& options, grf::Diagnostics& diagnostics) {
  const RenderOptions defaults;
  for (const OptionInfo& option : option_table()) {
    if (option_words(options, option) == option_words(defaults, option)) continue;
    if (const auto why = why_unused(options, option)) {
      diagnostics.warning(options.locations.of(option.key),
                          fmt::format("{} has no effect: {}", option.key, *why));
    }
  }
}

}  // namespace options
