#include "renderer/command/noise_command.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <ctime>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/job/render_job.h"
#include "renderer/transport/noise.h"

namespace command {
namespace {

using grf::Diagnostics;
using grf::ExitCode;
using Json = nlohmann::ordered_json;
using transport::CompiledScene;
using transport::NoiseShare;

constexpr int MostWidth = 192;
constexpr int MostSamples = 16;

/// Another setting, and what it is for.
struct Alternative {
  std::string_view flag;
  std::string_view value;
};
constexpr std::array Alternatives = {Alternative{"--pdf", "adaptive"}, Alternative{"--branches", "1"},
                                     Alternative{"--branches", "4"}};

struct Measured {
  transport::NoiseShares shares;
  double seconds = 0;  ///< of the processor, for all images
  Json report;

  /// The error's square times the time: what an image of a given error costs.
  double cost() const { return shares.error * shares.error * seconds; }
};

std::string lamp_name(const CompiledScene& scene, std::uint32_t index) {
  const std::vector<transport::Lamp>& lamps = scene.geometry().lamps;
  if (index >= lamps.size()) return "environment and background";
  const transport::Lamp& lamp = lamps[index];
  std::string name = lamp.name.empty() ? "lamp" : fmt::format("lamp '{}'", lamp.name);
  if (lamp.location.line > 0) name += fmt::format(", line {}", lamp.location.line);
  return name;
}

std::string bounce_name(std::uint32_t bounces) {
  if (bounces == 0) return "light that the eye sees";
  if (bounces == 1) return "direct light";
  return fmt::format("light of {} bounces", bounces);
}

std::string reflector_name(const CompiledScene& scene, std::uint32_t index) {
  if (index >= scene.tables().size()) return "none: the eye sees the light";
  const transport::TableInfo& table = scene.tables()[index];
  return table.scheme.empty() ? table.brdf : fmt::format("{}, sampled by {}", table.brdf, table.scheme);
}

template <class Name>
Json list_of(const std::vector<NoiseShare>& shares, const Name& name) {
  Json list = Json::array();
  for (const NoiseShare& share : shares) {
    list.push_back({{"name", name(share.index)}, {"noise", share.noise}, {"light", share.light}});
  }
  return list;
}

std::optional<Measured> measure(options::RenderOptions render_options, Diagnostics& diagnostics) {
  if (render_options.size.width > MostWidth) {
    render_options.size.height =
        std::max(1, render_options.size.height * MostWidth / render_options.size.width);
    render_options.size.width = MostWidth;
  }
  const auto job = job::render_job(render_options, diagnostics);
  if (!job) return std::nullopt;
  if (job->settings.integrator.integrator != transport::Integrator::Path) {
    diagnostics.error({}, "noise is shared out for the integrator `path` only");
    return std::nullopt;
  }
  const transport::NoiseSettings settings = {8, std::min(job->settings.samples, MostSamples)};
  const std::clock_t start = std::clock();
  const std::atomic<bool> stopped = false;
  const auto shares = transport::noise_shares(job->scene, job->settings, settings, stopped);
  if (!shares) {
    diagnostics.error({}, "the image has no noise");
    return std::nullopt;
  }
  Measured measured{*shares, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, {}};
  measured.report = {
      {"width", job->settings.width},
      {"height", job->settings.height},
      {"samples", shares->samples},
      {"error", shares->error},
      {"lamps", list_of(shares->lamps, [&](std::uint32_t i) { return lamp_name(job->scene, i); })},
      {"bounces", list_of(shares->bounces, bounce_name)},
      {"brdfs", list_of(shares->reflectors, [&](std::uint32_t i) { return reflector_name(job->scene, i); })}};
  return measured;
}

/// Measures other settings against those of the options.
Json tried(const options::RenderOptions& render_options, const Measured& now, Diagnostics& diagnostics) {
  Json list = Json::array();
  for (const Alternative& alternative : Alternatives) {
    options::RenderOptions other = render_options;
    if (!apply_flags({{std::string(alternative.flag), std::string(alternative.value)}}, other)) continue;
    if (other == render_options) continue;
    const auto measured = measure(other, diagnostics);
    if (!measured) continue;
    const double error = measured->shares.error / now.shares.error;
    list.push_back({{"flag", alternative.flag},
                    {"value", alternative.value},
                    {"variance", error * error},
                    {"time", measured->seconds / now.seconds},
                    {"cost", measured->cost() / now.cost()}});
  }
  return list;
}

void print_shares(const char* title, const Json& list) {
  fmt::print("{:>9}{:>9}  {}\n", "noise, %", "light, %", title);
  for (const Json& one : list) {
    fmt::print("{:>9.1f}{:>9.1f}  {}\n", 100 * one["noise"].get<double>(), 100 * one["light"].get<double>(),
               one["name"].get<std::string>());
  }
}

void print_noise(const Json& report) {
  fmt::print("error {:.3g} % with {} samples per pixel ({}x{} pixels)\n", 100 * report["error"].get<double>(),
             report["samples"].get<int>(), report["width"].get<int>(), report["height"].get<int>());
  print_shares("light from", report["lamps"]);
  print_shares("bounces", report["bounces"]);
  print_shares("reflected first by", report["brdfs"]);
  if (!report.contains("tried")) return;
  fmt::print("{:>9}{:>9}{:>9}  tried, relative to now\n", "variance", "time", "product");
  for (const Json& one : report["tried"]) {
    fmt::print("{:>9.2f}{:>9.2f}{:>9.2f}  {} {}\n", one["variance"].get<double>(), one["time"].get<double>(),
               one["cost"].get<double>(), one["flag"].get<std::string>(), one["value"].get<std::string>());
  }
}

}  // namespace

ExitCode noise(const NoiseArguments& arguments) {
  Diagnostics diagnostics;
  auto render_options = read_options(arguments.scene, diagnostics);
  std::optional<Measured> measured;
  if (render_options) {
    if (!apply_flags(arguments.flags, *render_options)) return ExitCode::BadCommandLine;
    measured = measure(*render_options, diagnostics);
    if (measured && arguments.tries)
      measured->report["tried"] = tried(*render_options, *measured, diagnostics);
  }
  fmt::print(stderr, "{}", diagnostics.to_text());
  if (!measured) return ExitCode::BadInput;
  if (arguments.json) {
    fmt::print("{}\n", measured->report.dump(2, ' ', false, Json::error_handler_t::replace));
  } else {
    print_noise(measured->report);
  }
  return ExitCode::Done;
}

}  // namespace command
