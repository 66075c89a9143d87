#include "renderer/command/brdf_command.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "grf/text_file.h"
#include "grf/write.h"
#include "renderer/command/brdf_plot.h"
#include "renderer/command/directions.h"
#include "renderer/command/json_values.h"
#include "renderer/command/printed.h"
#include "renderer/command/sampling_plot.h"
#include "renderer/image/image.h"
#include "renderer/plot/svg.h"
#include "renderer/reflectance/albedo.h"
#include "renderer/reflectance/brdf_instance.h"
#include "renderer/reflectance/scheme.h"
#include "renderer/reflectance/shader.h"
#include "renderer/reflectance/spectrum.h"
#include "renderer/studies/study.h"

namespace command {
namespace {

using grf::Diagnostics;
using grf::ExitCode;
using reflectance::Reflector;
using reflectance::Rgb;
using reflectance::Vec3f;

std::optional<Reflector> reflector_of(const BrdfArguments& arguments) {
  return printed(
      [&](Diagnostics& diagnostics) { return reflectance::read_instance(arguments.instance, diagnostics); });
}

std::optional<Vec3f> direction_option(const std::string& text, const char* option) {
  const auto angles = angles_option(text, option);
  return angles ? std::optional(direction_of(*angles)) : std::nullopt;
}

/// Values of a BRDF in RGB and, where it has them, at wavelengths.
class ValueList {
 public:
  ValueList(const Reflector& reflector, std::vector<float> wavelengths)
      : reflector_(reflector), wavelengths_(std::move(wavelengths)) {}

  void add(const Vec3f& u, const Vec3f& v) {
    values_.push_back(reflector_.evaluate(u, v));
    if (wavelengths_.empty()) return;
    spectra_.push_back(
        reflectance::spectrum_of(reflector_.brdf(), Imath::V3d(u), Imath::V3d(v), wavelengths_));
  }

  void print(bool json) const { json ? print_json() : print_lines(); }

 private:
  void print_json() const {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Rgb& value : values_) list.push_back(json_array(value));
    nlohmann::ordered_json all = {{"values", list}};
    if (!wavelengths_.empty()) {
      all["wavelengths"] = wavelengths_;
      all["spectra"] = spectra_;
    }
    fmt::print("{}\n", json_text(all, true));
  }

  void print_lines() const {
    if (!wavelengths_.empty()) fmt::print("# R G B and {:.6g} nm\n", fmt::join(wavelengths_, " "));
    for (std::size_t i = 0; i < values_.size(); ++i) {
      fmt::print("{} {} {}", values_[i].x, values_[i].y, values_[i].z);
      if (!wavelengths_.empty()) fmt::print(" {:.7g}", fmt::join(spectra_[i], " "));
      fmt::print("\n");
    }
  }

  const Reflector& reflector_;
  std::vector<float> wavelengths_;  ///< in nanometres; empty: RGB alone
  std::vector<Rgb> values_;
  std::vector<std::vector<double>> spectra_;
};

/// Returns the wavelengths to evaluate: those asked for, or the BRDF's own. Nothing, after an error, if some
/// are asked for of a BRDF that has RGB alone.
std::optional<std::vector<float>> wavelengths_for(const Reflector& reflector,
                                                  const BrdfArguments& arguments) {
  std::vector<float> own = reflectance::wavelengths_of(reflector.brdf());
  if (arguments.wavelengths.empty()) return own;
  if (!own.empty()) return arguments.wavelengths;
  fmt::print(stderr,
             "error: --wavelengths: this BRDF has values in RGB alone; 'he', 'westin', 'thinfilm' and 'rgl' "
             "files with spectra have wavelengths\n");
  return std::nullopt;
}

ExitCode evaluate_lines(const Reflector& reflector, std::vector<float> wavelengths, bool json) {
  ValueList values(reflector, std::move(wavelengths));
  std::string line;
  for (std::size_t number = 1; std::getline(std::cin, line); ++number) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    const auto angles = numbers_of(line, 4, 4);
    if (!angles) {
      fmt::print(stderr, "standard input:{}: error: expected theta_u phi_u theta_v phi_v, in radians\n  {}\n",
                 number, line);
      return ExitCode::BadInput;
    }
    values.add(direction_of({(*angles)[0], (*angles)[1]}), direction_of({(*angles)[2], (*angles)[3]}));
  }
  values.print(json);
  return ExitCode::Done;
}

/// Makes the study of a FIT file as the tool `fitplot` does.
std::optional<studies::Study> study_of_fit(const std::string& path) {
  studies::ToolState state;
  state.settings.keyword = "fitplot";
  state.files.push_back({path, {}});
  return printed([&](Diagnostics& diagnostics) { return studies::study_of(state, {}, diagnostics); });
}

nlohmann::ordered_json to_json(const grf::ParameterInfo& parameter) {
  constexpr std::array Kinds = {"number", "reflectance", "boolean", "word"};
  nlohmann::ordered_json json = {{"name", parameter.name},
                                 {"kind", Kinds.at(static_cast<std::size_t>(parameter.kind))},
                                 {"min", grf::shortest(parameter.minimum)},
                                 {"max", grf::shortest(parameter.maximum)},
                                 {"default", grf::shortest(parameter.default_value)},
                                 {"logarithmic", parameter.scale == grf::ParameterScale::Logarithmic},
                                 {"unit", parameter.unit},
                                 {"help", parameter.help}};
  if (parameter.default_rgb) json["default_rgb"] = json_array(*parameter.default_rgb);
  if (!parameter.default_from.empty()) json["default_from"] = parameter.default_from;
  if (!parameter.choices.empty()) json["choices"] = parameter.choices;
  return json;
}

nlohmann::ordered_json to_json(const grf::ModelInfo& model) {
  nlohmann::ordered_json parameters = nlohmann::ordered_json::array();
  for (const grf::ParameterInfo& parameter : model.parameters) {
    parameters.push_back(to_json(parameter));
  }
  return {{"keyword", model.keyword},
          {"title", model.title},
          {"paper", model.paper},
          {"about", model.description},
          {"formula", model.formula},
          {"example", model.example},
          {"parameters", parameters},
          {"isotropic", model.not_isotropic.empty()},
          {"reciprocal", model.not_reciprocal.empty()},
          {"conserves_energy", model.not_conserving.empty()},
          {"not_isotropic", model.not_isotropic},
          {"not_reciprocal", model.not_reciprocal},
          {"not_conserving", model.not_conserving},
          {"not_continuous", model.not_continuous}};
}

/// Wraps text to the width of a terminal.
std::string wrapped(std::string_view words, std::string_view indent) {
  constexpr std::size_t Width = 100;
  std::string text;
  std::size_t column = Width;
  while (!words.empty()) {
    const std::size_t length = std::min(words.find(' '), words.size());
    const bool fits = column + 1 + length <= Width;
    if (!fits && !text.empty()) text += '\n';
    text.append(fits ? " " : indent).append(words.substr(0, length));
    column = (fits ? column + 1 : indent.size()) + length;
    words.remove_prefix(std::min(words.size(), length + 1));
  }
  return text;
}

void print_model(const grf::ModelInfo& model) {
  fmt::print("{:<14} {}{}{}\n", model.keyword, model.title, model.paper.empty() ? "" : ". ", model.paper);
  if (!model.description.empty()) fmt::print("{}\n", wrapped(model.description, "    "));
  for (const grf::ParameterInfo& parameter : model.parameters) {
    fmt::print("    {:<8} {} to {}, {} by default: {}\n", parameter.name, parameter.minimum,
               parameter.maximum,
               parameter.default_from.empty() ? fmt::format("{}", parameter.default_value)
                                              : std::string(parameter.default_from),
               parameter.help);
  }
  const auto print_line = [](const char* property, std::string_view words) {
    if (!words.empty()) fmt::print("    {}: {}\n", property, words);
  };
  print_line("not always isotropic", model.not_isotropic);
  print_line("not reciprocal", model.not_reciprocal);
  print_line("energy", model.not_conserving);
  print_line("example", model.example);
}

}  // namespace

ExitCode list_brdfs(const BrdfArguments& arguments) {
  const std::vector<grf::ModelInfo> models = reflectance::brdf_infos();
  if (!arguments.json) {
    std::for_each(models.begin(), models.end(), print_model);
    return ExitCode::Done;
  }
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const grf::ModelInfo& model : models) list.push_back(to_json(model));
  fmt::print("{}\n", json_text(nlohmann::ordered_json{{"models", list}}, false));
  return ExitCode::Done;
}

ExitCode evaluate_brdf(const BrdfArguments& arguments) {
  const auto reflector = reflector_of(arguments);
  if (!reflector) return ExitCode::BadInput;
  const auto wavelengths = wavelengths_for(*reflector, arguments);
  if (!wavelengths) return ExitCode::BadCommandLine;
  if (arguments.view.empty() && arguments.light.empty())
    return evaluate_lines(*reflector, *wavelengths, arguments.json);
  const auto u = direction_option(arguments.view, "--u");
  const auto v = direction_option(arguments.light, "--v");
  if (!u || !v) return ExitCode::BadCommandLine;
  ValueList values(*reflector, *wavelengths);
  values.add(*u, *v);
  values.print(arguments.json);
  return ExitCode::Done;
}

ExitCode print_albedo(const BrdfArguments& arguments) {
  const auto reflector = reflector_of(arguments);
  if (!reflector) return ExitCode::BadInput;
  const auto u = direction_option(arguments.view, "--u");
  if (!u) return ExitCode::BadCommandLine;
  const Rgb value = reflectance::albedo(*reflector, *u);
  if (arguments.json) {
    fmt::print("{}\n", json_text(nlohmann::ordered_json{{"albedo", json_array(value)}}, true));
  } else {
    fmt::print("{} {} {}\n", value.x, value.y, value.z);
  }
  return ExitCode::Done;
}

ExitCode print_glsl(const BrdfArguments& arguments) {
  const auto reflector = reflector_of(arguments);
  if (!reflector) return ExitCode::BadInput;
  const auto shader = reflectance::shader_of(reflector->brdf());
  if (!shader) {
    fmt::print(
        stderr,
        "error: '{}' has no shader: its values are read from a file, or it is a sum of too many terms\n",
        arguments.instance);
    return ExitCode::BadInput;
  }
  if (!arguments.json) {
    fmt::print("{}", shader->text);
    return ExitCode::Done;
  }
  nlohmann::ordered_json values = nlohmann::ordered_json::array();
  for (const Rgb& value : shader->parameters) values.push_back(json_array(value));
  fmt::print("{}\n",
             json_text(nlohmann::ordered_json{{"text", shader->text}, {"parameters", values}}, false));
  return ExitCode::Done;
}

ExitCode plot_brdf(const BrdfArguments& arguments) {
  Diagnostics diagnostics;
  std::optional<plot::Svg> picture;
  std::string summary;
  if (image::has_extension(arguments.instance, "fit")) {
    const auto study = study_of_fit(arguments.instance);
    if (!study) return ExitCode::BadInput;
    picture = study->figure;
    summary = study->summary;
  } else if (arguments.pdf.empty()) {
    const auto reflector = reflector_of(arguments);
    if (!reflector) return ExitCode::BadInput;
    picture = picture_of(*reflector, arguments.instance);
  } else {
    std::vector<Angles> views;
    for (const std::string& text : arguments.views) {
      const auto view = angles_option(text, "--u");
      if (!view) return ExitCode::BadCommandLine;
      views.push_back(*view);
    }
    const auto instance = printed([&](Diagnostics& reading) {
      return reflectance::read_sampled_instance(arguments.instance, arguments.pdf, reading);
    });
    if (!instance) return ExitCode::BadInput;
    picture = picture_of_sampling(*instance, arguments.instance, arguments.pdf, views);
  }
  const bool written = plot::write_picture(*picture, arguments.output, diagnostics);
  fmt::print(stderr, "{}", diagnostics.to_text());
  if (!written) return ExitCode::BadInput;
  if (arguments.json) {
    nlohmann::ordered_json result = {{"file", arguments.output}};
    if (!summary.empty()) result["summary"] = summary;
    fmt::print("{}\n", json_text(result, true));
  } else {
    if (!summary.empty()) fmt::print("{}\n", summary);
    fmt::print("{}\n", arguments.output);
  }
  return ExitCode::Done;
}

}  // namespace command
