#include "renderer/command/noise_command.h"

#include <atomic>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/command/json_values.h"
#include "renderer/job/noise_advice.h"

namespace command {
namespace {

using grf::Diagnostics;
using grf::ExitCode;
using job::NoiseChange;
using job::NoisePart;
using job::NoiseReport;
using transport::MeasuredRatio;
using transport::NoiseRatios;
using Json = nlohmann::ordered_json;

/// A change, and what it does if it was tried.
struct Trial {
  NoiseChange change;
  std::optional<NoiseRatios> ratios;
};

void add_place(const NoisePart& part, Json& json) {
  if (part.kind == NoisePart::Kind::Lamp) {
    json["kind"] = part.lamp.is_area_light ? "area light" : "mesh";
    json["number"] = part.lamp.number;
  } else if (part.kind == NoisePart::Kind::Bounces) {
    json["bounces"] = part.share.index;
  } else if (part.kind == NoisePart::Kind::Brdf) {
    json["brdf"] = part.tables.brdf;
    json["scheme"] = part.tables.scheme;
  }
}

Json list_of(const std::vector<NoisePart>& parts) {
  Json list = Json::array();
  for (const NoisePart& part : parts) {
    Json one = {{"name", part.name}, {"noise", part.share.noise}, {"light", part.share.light}};
    add_place(part, one);
    list.push_back(std::move(one));
  }
  return list;
}

Json json_of_trial(const Trial& trial) {
  const NoiseChange& change = trial.change;
  Json json = {{"change", change.word()}};
  if (change.option.empty()) {
    json["brdf"] = change.brdf;
  } else {
    json["option"] = change.option;
    json["flag"] = options::find_option(change.option)->flag;
  }
  json["value"] = change.value;
  json["before"] = change.before;
  if (!trial.ratios) return json;
  const auto add = [&](const std::string& name, const MeasuredRatio& ratio) {
    json[name] = ratio.value;
    json[name + "_interval"] = {ratio.low, ratio.high};
  };
  add("variance", trial.ratios->variance);
  add("time", trial.ratios->time);
  add("cost", trial.ratios->cost);
  json["pays"] = job::pays(*trial.ratios);
  json["advice"] = advice_of(change, *trial.ratios);
  return json;
}

Json json_of_report(const NoiseReport& report) {
  return {{"width", report.width},          {"height", report.height},
          {"samples", report.samples},      {"error", report.error},
          {"lamps", list_of(report.lamps)}, {"bounces", list_of(report.bounces)},
          {"brdfs", list_of(report.brdfs)}, {"advice", advice_of(report)}};
}

void print_line(const Json& json) {
  fmt::print("{}\n", json_text(json, true));
  std::fflush(stdout);
}

void print_shares(const char* title, const std::vector<NoisePart>& parts) {
  fmt::print("{:>9}{:>9}  {}\n", "noise, %", "light, %", title);
  for (const NoisePart& part : parts) {
    fmt::print("{:>9.1f}{:>9.1f}  {}\n", 100 * part.share.noise, 100 * part.share.light, part.name);
  }
}

void print_report(const NoiseReport& report) {
  fmt::print("error {:.3g} % with {} samples per pixel ({}x{} pixels)\n", 100 * report.error, report.samples,
             report.width, report.height);
  print_shares("light from", report.lamps);
  print_shares("bounces", report.bounces);
  print_shares("reflected first by", report.brdfs);
  for (const std::string& sentence : advice_of(report)) fmt::print("{}\n", sentence);
}

void print_trials(const std::vector<Trial>& trials) {
  fmt::print("{:>9}{:>9}{:>9}  tried, relative to now\n", "variance", "time", "product");
  for (const auto& [change, ratios] : trials) {
    if (!ratios) continue;
    fmt::print("{:>9.2f}{:>9.2f}{:>9.2f}  {}\n", ratios->variance.value, ratios->time.value,
               ratios->cost.value,
               change.option.empty()
                   ? fmt::format("{} for {}", change.value, change.brdf)
                   : fmt::format("{} {}", options::find_option(change.option)->flag, change.value));
  }
  for (const auto& [change, ratios] : trials) {
    if (ratios) fmt::print("{}\n", advice_of(change, *ratios));
  }
}

/// The changes to be tried: all of them, or the one that is asked for. Empty after an error.
std::optional<std::vector<Trial>> trials_of(const NoiseArguments& arguments,
                                            const std::vector<NoiseChange>& changes) {
  std::vector<Trial> trials;
  for (const NoiseChange& change : changes) {
    if (arguments.change.empty() || change.word() == arguments.change) trials.push_back({change, {}});
  }
  if (!trials.empty() || arguments.change.empty()) return trials;
  std::vector<std::string> words;
  for (const NoiseChange& change : changes) words.push_back(change.word());
  fmt::print(stderr, "error: --change: found '{}', expected one of {}\n", arguments.change,
             fmt::join(words, ", "));
  return std::nullopt;
}

}  // namespace

ExitCode noise(const NoiseArguments& arguments) {
  Diagnostics diagnostics;
  auto render_options = read_options(arguments.scene, diagnostics);
  if (render_options && !apply_flags(arguments.flags, *render_options)) return ExitCode::BadCommandLine;
  const std::atomic<bool> stopped = false;
  std::optional<NoiseReport> report;
  if (render_options) report = job::noise_report(*render_options, stopped, diagnostics);
  fmt::print(stderr, "{}", diagnostics.to_text());
  if (!report) return ExitCode::BadInput;
  auto trials = trials_of(arguments, noise_changes(*render_options, *report));
  if (!trials) return ExitCode::BadCommandLine;
  const bool prints_lines = progress_style_of(arguments.progress) == ProgressStyle::Json;
  Json json = json_of_report(*report);
  json["changes"] = Json::array();
  for (const Trial& trial : *trials) json["changes"].push_back(json_of_trial(trial));
  if (prints_lines) print_line(json);
  if (!arguments.json && !prints_lines) print_report(*report);

  Diagnostics problems;
  job::NoiseTrials measured(*render_options);
  if (arguments.tries || !arguments.change.empty()) {
    json["tried"] = Json::array();
    for (Trial& trial : *trials) {
      trial.ratios = measured.with(trial.change, stopped, problems);
      if (!trial.ratios) continue;
      json["tried"].push_back(json_of_trial(trial));
      if (prints_lines) print_line({{"tried", json_of_trial(trial)}});
    }
    if (!arguments.json && !prints_lines) print_trials(*trials);
  }
  fmt::print(stderr, "{}", problems.to_text());
  if (arguments.json && !prints_lines) fmt::print("{}\n", json_text(json, false));
  return ExitCode::Done;
}

}  // namespace command
