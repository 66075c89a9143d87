#include "renderer/command/brdf_fit.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "grf/read.h"
#include "grf/text_file.h"
#include "renderer/command/brdf_fit_report.h"
#include "renderer/command/json_values.h"
#include "renderer/command/printed.h"
#include "renderer/fit/fit.h"
#include "renderer/image/image.h"
#include "renderer/reflectance/brdf_instance.h"

namespace command {
namespace {

using fit::Fit;
using fit::Target;
using grf::Diagnostics;
using grf::ExitCode;

constexpr std::size_t UsualPairs = 4000;
constexpr std::size_t UsualCells = 20'000;

std::optional<reflectance::Brdf> read_data_as_brdf(const std::string& data, Diagnostics& diagnostics) {
  const auto reflector = reflectance::read_instance(data, diagnostics);
  return reflector ? std::optional(reflector->brdf()) : std::nullopt;
}

/// Reads the data; nothing after an error.
std::optional<BrdfFits> read_data(const BrdfFitArguments& arguments, Diagnostics& diagnostics) {
  BrdfFits fits;
  fits.data = arguments.data;
  std::optional<fit::Observations> observations;
  std::string path;
  if (image::has_extension(arguments.data, "csv")) {
    path = arguments.data;
    observations = fit::read_csv(path, diagnostics);
  } else if ((fits.brdf = read_data_as_brdf(arguments.data, diagnostics))) {
    const std::size_t usual =
        std::holds_alternative<reflectance::Measured>(*fits.brdf) ? UsualCells : UsualPairs;
    observations = fit::sampled(*fits.brdf, arguments.samples > 0 ? arguments.samples : usual, diagnostics);
  }
  if (!observations) return std::nullopt;
  auto usable = fit::usable(*std::move(observations), path, diagnostics);
  if (!usable) return std::nullopt;
  fits.observations = *std::move(usable);
  return fits;
}

/// Parses `NAME=VALUE` with GRF's syntax of values; nothing after an error, of which one is a name that no
/// model to fit has.
std::optional<std::vector<grf::Argument>> fixed_arguments(const std::vector<std::string>& texts,
                                                          const std::vector<Target>& targets,
                                                          Diagnostics& diagnostics) {
  const std::vector<grf::ModelInfo> models = reflectance::brdf_infos();
  const auto has_parameter = [&](const std::string& name) {
    return std::any_of(targets.begin(), targets.end(), [&](const Target& target) {
      return std::any_of(target.keywords.begin(), target.keywords.end(), [&](const std::string& keyword) {
        const grf::ModelInfo* info = grf::find_model(models, keyword);
        return info != nullptr && info->find(name) != nullptr;
      });
    });
  };
  std::vector<grf::Argument> fixed;
  for (const std::string& text : texts) {
    const auto model = grf::read_brdf(targets[0].keywords[0] + " " + text, "--fix", diagnostics);
    if (!model) return std::nullopt;
    if (model->arguments.empty()) {
      diagnostics.error({}, fmt::format("--fix {}: expected NAME=VALUE", text));
      return std::nullopt;
    }
    for (const grf::Argument& argument : model->arguments) {
      if (!has_parameter(argument.name)) {
        diagnostics.error({},
                          fmt::format("--fix {}: no model to fit has a parameter '{}'", text, argument.name));
        return std::nullopt;
      }
      fixed.push_back(argument);
    }
  }
  return fixed;
}

/// Fits all targets; false after an error.
bool add_fits(const std::vector<Target>& targets, const fit::FitSettings& settings, BrdfFits& fits,
              Diagnostics& diagnostics) {
  for (const Target& target : targets) {
    auto fit = fit::fit_brdf(target, fits.observations, settings, diagnostics);
    if (!fit) return false;
    for (const std::string& warning : fit->warnings)
      diagnostics.warning({}, fmt::format("{}: {}", target.name(), warning));
    fits.fits.push_back(*std::move(fit));
  }
  std::vector<Fit> sorted;
  for (const std::size_t place : ranking(fits.fits, settings.metric)) sorted.push_back(fits.fits[place]);
  fits.fits = std::move(sorted);
  return true;
}

nlohmann::ordered_json fitted_json(const Fit& fit) {
  auto errors = nlohmann::ordered_json::object();
  for (const fit::Metric metric : fit::Metrics) {
    errors[std::string(fit::name_of(metric))] = {{"rms", number_or_null(fit.error(metric).absolute)},
                                                 {"relative", number_or_null(fit.error(metric).relative)}};
  }
  auto parameters = nlohmann::ordered_json::array();
  for (const fit::FittedParameter& parameter : fit.parameters) {
    const bool has_interval = parameter.is_determined && !parameter.is_at_bound;
    parameters.push_back({{"term", parameter.term + 1},
                          {"name", parameter.name},
                          {"channel", parameter.channel ? nlohmann::ordered_json(*parameter.channel)
                                                        : nlohmann::ordered_json(nullptr)},
                          {"value", parameter.value},
                          {"interval", has_interval ? nlohmann::ordered_json{parameter.low, parameter.high}
                                                    : nlohmann::ordered_json(nullptr)},
                          {"determined", parameter.is_determined},
                          {"at_bound", parameter.is_at_bound}});
  }
  return {{"model", fit.target.name()}, {"grf", text_of(fit)}, {"errors", errors},
          {"parameters", parameters},   {"held", fit.held},    {"warnings", fit.warnings},
          {"seconds", fit.seconds}};
}

void print_json(const BrdfFits& fits) {
  auto list = nlohmann::ordered_json::array();
  for (const Fit& one : fits.fits) list.push_back(fitted_json(one));
  const nlohmann::ordered_json all = {{"data",
                                       {{"name", fits.data},
                                        {"description", fits.observations.description},
                                        {"values", fits.observations.list.size()},
                                        {"isotropic", fits.observations.is_isotropic}}},
                                      {"metric", fit::name_of(fits.metric)},
                                      {"fits", list}};
  fmt::print("{}\n", json_text(all, true));
}

void print_text(const BrdfFits& fits) {
  fmt::print("data: {}\n", fits.observations.description);
  std::size_t width = 5;
  for (const Fit& one : fits.fits) width = std::max(width, one.target.name().size());
  fmt::print("\n{:<{}}", "model", width);
  for (const fit::Metric metric : fit::Metrics) fmt::print("  {:>12}", fmt::format("{} %", name_of(metric)));
  fmt::print("  {:>8}\n", "seconds");
  for (const Fit& one : fits.fits) {
    fmt::print("{:<{}}", one.target.name(), width);
    for (const fit::FitError& error : one.errors) fmt::print("  {:>12.4g}", 100 * error.relative);
    fmt::print("  {:>8.2g}\n", one.seconds);
  }
  for (const Fit& one : fits.fits) {
    fmt::print("\n{}", text_of(one));
    for (const fit::FittedParameter& parameter : one.parameters)
      fmt::print("  {:<12} {:>10.5g}  {}\n", name_of(parameter, one), parameter.value,
                 interval_of(parameter));
    for (const std::string& held : one.held) fmt::print("  held: {}\n", held);
  }
}

}  // namespace

ExitCode fit_brdfs(const BrdfFitArguments& arguments) {
  const auto targets = fit::targets_of(arguments.targets, arguments.lobes);
  if (!targets) {
    fmt::print(stderr, "error: --to {}: expected models such as ward,ggx,\"combine ggx eon\"\n",
               arguments.targets);
    return ExitCode::BadCommandLine;
  }
  Diagnostics diagnostics;
  const auto fixed = fixed_arguments(arguments.fixed, *targets, diagnostics);
  auto fits = fixed ? read_data(arguments, diagnostics) : std::nullopt;
  fit::FitSettings settings;
  bool is_done = fits.has_value();
  if (is_done) {
    settings.metric = fit::metric_of(arguments.metric).value();
    settings.fixed = *fixed;
    settings.threads = arguments.threads;
    fits->metric = settings.metric;
    is_done = add_fits(*targets, settings, *fits, diagnostics);
  }
  if (is_done && !arguments.output.empty())
    is_done = grf::replace_file(arguments.output, text_of(fits->fits.front()), diagnostics);
  if (is_done && !arguments.report.empty()) is_done = write_fit_report(*fits, arguments.report, diagnostics);
  print(diagnostics);
  if (!is_done) return ExitCode::BadInput;
  arguments.json ? print_json(*fits) : print_text(*fits);
  return ExitCode::Done;
}

}  // namespace command
