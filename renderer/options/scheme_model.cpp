#include "renderer/options/scheme_model.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "grf/keywords.h"

namespace options {
namespace {

/// An option that was given, the schemes that have a parameter for it, and that parameter.
struct Given {
  std::string_view key;
  std::vector<std::string_view> schemes;
  std::string_view parameter;
  grf::Value value;
};

constexpr std::string_view FactorsFile = "BPT_Pdf_Factors_File";

std::vector<Given> given_options(const RenderOptions& options) {
  std::vector<Given> given;
  const std::vector<std::string_view> lobes = {"hemisphere", "sphere"};
  const auto add = [&](std::string_view key, const std::vector<std::string_view>& schemes,
                       std::string_view parameter, const auto& value) {
    if constexpr (std::is_same_v<decltype(*value), const bool&>) {
      if (value) given.push_back({key, schemes, parameter, *value});
    } else {
      if (value) given.push_back({key, schemes, parameter, static_cast<float>(*value)});
    }
  };
  const auto add_pair = [&](std::string_view key, std::string_view scheme, std::string_view first,
                            std::string_view second, const std::optional<IntegerPair>& pair) {
    if (!pair) return;
    given.push_back({key, {scheme}, first, static_cast<float>(pair->first)});
    given.push_back({key, {scheme}, second, static_cast<float>(pair->second)});
  };
  add("BPT_Pdf_LobeExponent", lobes, "exp", options.lobe_exponent);
  add("BPT_Pdf_AnisoNu", {"anisotropic"}, "nu", options.anisotropic_nu);
  add("BPT_Pdf_AnisoNv", {"anisotropic"}, "nv", options.anisotropic_nv);
  add("BPT_QT_Precomputed", {"adaptive"}, "nQT", options.trees_over_theta);
  add("BPT_QT_Anisotropic", {"adaptive"}, "nAnisoQT", options.trees_over_phi);
  add("BPT_QT_avgnmax", {"adaptive"}, "nmax", options.mean_tries);
  add("BPT_QT_ImgRes", {"adaptive"}, "res", options.tree_resolution);
  add("BPT_QT_release", {"adaptive"}, "release", options.releases_table);
  add_pair("BPT_Pdf_Factors_ResU", "factored", "uTh", "uPh", options.factors_u);
  add_pair("BPT_Pdf_Factors_ResP", "factored", "pTh", "pPh", options.factors_p);
  add_pair("BPT_Pdf_Factors_JK", "factored", "J", "K", options.factors);
  add("BPT_Pdf_Factors_Half", {"factored"}, "half", options.factors_by_half_vector);
  add_pair("BPT_Pdf_CDF_Res", "cascadeCDF", "nTh", "nPh", options.cdf_resolution);
  add("BPT_Pdf_CDF_Compress", {"cascadeCDF"}, "compress", options.compresses_cdf);
  return given;
}

/// What a scene calls the scheme of that name.
std::string keyword_of(std::string_view name) {
  if (grf::same_keyword(name, "Disk")) return "adaptive";
  return grf::same_keyword(name, "CascadeCDF") ? "cascadeCDF" : grf::lower_case(name);
}

bool is_for(const Given& option, std::string_view keyword) {
  return std::any_of(option.schemes.begin(), option.schemes.end(),
                     [&](std::string_view scheme) { return grf::same_keyword(scheme, keyword); });
}

}  // namespace

std::optional<grf::PdfModel> scheme_model(const RenderOptions& options) {
  if (options.name.empty()) return std::nullopt;
  grf::PdfModel model;
  model.keyword = keyword_of(options.name);
  model.location = options.locations.of("BPT_Pdf_Name");
  for (const Given& option : given_options(options)) {
    if (!is_for(option, model.keyword)) continue;
    model.arguments.push_back(
        {std::string(option.parameter), option.value, options.locations.of(option.key)});
  }
  return model;
}

void warn_of_unused_options(const RenderOptions& options, grf::Diagnostics& diagnostics) {
  const std::string keyword = keyword_of(options.name);
  const auto warn = [&](std::string_view key) {
    const std::string why =
        options.name.empty() ? "no BPT_Pdf_Name is given, and the scene's schemes have their own parameters"
                             : fmt::format("the scheme '{}' does not use it", keyword);
    diagnostics.warning(options.locations.of(key), fmt::format("{} has no effect: {}", key, why));
  };
  std::string_view last;
  for (const Given& option : given_options(options)) {
    if (option.key != last && (options.name.empty() || !is_for(option, keyword))) warn(option.key);
    last = option.key;
  }
  if (!options.factors_file.empty() && keyword != "factored") warn(FactorsFile);
  const auto warn_of = [&](std::string_view key, std::string_view why) {
    diagnostics.warning(options.locations.of(key), fmt::format("{} has no effect: {}", key, why));
  };
  const bool is_naive = options.integrator == "naive";
  if (is_naive && options.samples) {
    warn_of("BPT_Samples", "the integrator 'naive' takes Pixel_SampleRes x NSecRaysRoot^2");
  }
  if (is_naive && options.uses_irradiance) {
    warn_of("BPT_Irradiance", "the integrator 'naive' finds all light by its own rays");
  }
  const std::string_view places = "the integrator 'path' spreads its samples by itself";
  if (!is_naive && options.pixel_radial) warn_of("BPT_Pixel_Radial", places);
  if (!is_naive && !options.pixel_random) warn_of("BPT_Pixel_Random", places);
  const bool is_backplate = options.projection == "backplate";
  if (options.environment.empty() && is_backplate) {
    warn_of("BPT_EM_Projection", "no BPT_EM_Background is given");
  }
  if (options.resampling && (options.environment.empty() || is_backplate)) {
    warn_of("BPT_RIS", is_backplate ? "a backplate lights nothing" : "no BPT_EM_Background is given");
  } else if (options.resampling && is_naive) {
    warn_of("BPT_RIS", "the integrator 'naive' samples no light");
  }
}

}  // namespace options
