#include "renderer/command/plan_command.h"

#include <cstdio>
#include <filesystem>
#include <map>
#include <optional>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "grf/text_file.h"
#include "grf/wording.h"
#include "renderer/command/json_values.h"
#include "renderer/command/render_run.h"
#include "renderer/image/image_file.h"
#include "renderer/job/target_pilot.h"
#include "renderer/plan/table_bytes.h"

namespace command {
namespace {

using grf::Diagnostics;
using grf::ExitCode;
using Json = nlohmann::ordered_json;
using plan::Plan;

/// Names surfaces by their mesh and their place in its list, and lights by their number in the file, from 0.
Json places_of(const plan::PlannedEffect& effect) {
  Json places = Json::array();
  for (const plan::SurfacePlace& place : effect.places) {
    if (place.mesh == nullptr) {
      places.push_back({{"light", place.index}});
      continue;
    }
    places.push_back({{"mesh", place.mesh->name}, {"surface", place.index}});
  }
  return places;
}

Json effects_of(const Plan& plan) {
  Json effects = Json::array();
  for (const plan::PlannedEffect& effect : plan.effects) {
    effects.push_back({{"name", name_of(effect.effect)},
                       {"needed", effect.is_needed},
                       {"why", effect.why},
                       {"places", places_of(effect)}});
  }
  return effects;
}

Json tables_of(const grf::Scene& scene, const job::RenderPlan& planned, Diagnostics& diagnostics) {
  const auto bytes = plan::table_bytes(scene, planned.compile_settings, diagnostics);
  Json tables = Json::array();
  for (const plan::PlannedTable& table : planned.plan.tables) {
    const auto known = bytes.find({table.identity, table.scheme});
    tables.push_back({{"brdf", table.brdf},
                      {"pdf", table.scheme},
                      {"bytes", known != bytes.end() ? Json(known->second) : Json(nullptr)},
                      {"needed", table.is_needed},
                      {"why", table.is_needed ? "paths can reach it" : table.why}});
  }
  return tables;
}

Json textures_of(const Plan& plan) {
  Json textures = Json::array();
  for (const plan::PlannedTexture& texture : plan.textures) {
    std::error_code missing;
    const std::uintmax_t bytes = std::filesystem::file_size(texture.file, missing);
    textures.push_back({{"file", texture.file},
                        {"file_bytes", missing ? Json(nullptr) : Json(bytes)},
                        {"needed", texture.is_needed},
                        {"why", texture.is_needed ? "on faces that paths can reach" : texture.why}});
  }
  return textures;
}

std::uint64_t sum_of_left_out(const Json& list, const char* bytes) {
  std::uint64_t sum = 0;
  for (const Json& one : list) {
    if (!one["needed"].get<bool>() && !one[bytes].is_null()) sum += one[bytes].get<std::uint64_t>();
  }
  return sum;
}

Json report_of(const grf::Scene& scene, const job::RenderPlan& planned, Diagnostics& diagnostics) {
  const Plan& plan = planned.plan;
  Json report;
  report["effects"] = effects_of(plan);
  report["tables"] = tables_of(scene, planned, diagnostics);
  report["textures"] = textures_of(plan);
  report["depth"] = plan.depth;
  report["why_depth"] = plan.why_depth;
  report["saved"] = {{"table_bytes", sum_of_left_out(report["tables"], "bytes")},
                     {"texture_file_bytes", sum_of_left_out(report["textures"], "file_bytes")},
                     {"scatterings", plan.asked_depth - plan.depth}};
  return report;
}

std::string bytes_text(const Json& bytes) {
  return bytes.is_null() ? "unknown size" : grf::counted(bytes.get<std::size_t>(), "byte", "bytes");
}

void print_text(const Json& report) {
  for (const Json& effect : report["effects"]) {
    fmt::print("{} {:<24}{}\n", effect["needed"].get<bool>() ? "+" : "-", effect["name"].get<std::string>(),
               effect["why"].get<std::string>());
  }
  const auto sign = [](const Json& one) { return one["needed"].get<bool>() ? "+" : "-"; };
  for (const Json& table : report["tables"]) {
    fmt::print("{} table of `{}` for `{}`, {}: {}\n", sign(table), table["brdf"].get<std::string>(),
               table["pdf"].get<std::string>(), bytes_text(table["bytes"]), table["why"].get<std::string>());
  }
  for (const Json& texture : report["textures"]) {
    fmt::print("{} texture `{}`, {}: {}{}\n", sign(texture),
               grf::file_name(texture["file"].get<std::string>()),
               texture["file_bytes"].is_null() ? "no such file" : bytes_text(texture["file_bytes"]),
               texture["why"].get<std::string>(),
               texture["needed"].get<bool>() ? "" : "; a render does not check that the file exists");
  }
  fmt::print("depth {}: {}\n", report["depth"].get<int>(), report["why_depth"].get<std::string>());
  const Json& saved = report["saved"];
  fmt::print("saved: {} of tables (built here only to measure them), {} of texture files, {}\n",
             bytes_text(saved["table_bytes"]), bytes_text(saved["texture_file_bytes"]),
             grf::counted(saved["scatterings"].get<std::size_t>(), "bounce", "bounces"));
}

Json json_of_share(const std::optional<job::LostShare>& share) {
  if (!share) return nullptr;
  return {{"share", share->value}, {"interval", {share->low, share->high}}};
}

Json json_of_effect(const job::MeasuredEffect& measured) {
  return {{"name", name_of(measured.effect)},
          {"light", json_of_share(measured.light)},
          {"time", json_of_share(measured.time)},
          {"difference", number_or_null(measured.difference)}};
}

/// Writes both images of an effect to a folder. Returns false after an error.
bool write_images(const job::MeasuredEffect& measured, const std::string& folder, Diagnostics& diagnostics) {
  const std::string stem = (std::filesystem::path(folder) / name_of(measured.effect)).string();
  return image::write_image({measured.full}, stem + "_full.exr", diagnostics) &&
         image::write_image({measured.without}, stem + "_without.exr", diagnostics);
}

/// Returns which paths suffice for a target error: for each number of bounces the bias and the cost, and the
/// number that is chosen. Updates the plan. Null without a target error, or after an error.
Json target_error_of(const options::RenderOptions& render_options, Plan& plan, Diagnostics& diagnostics) {
  Diagnostics repeated;  // the plan gave the warnings
  auto job = render_options.target_error ? job::render_job(render_options, repeated) : std::nullopt;
  if (!job) {
    for (const grf::Diagnostic& each : repeated.entries()) {
      if (each.severity == grf::Severity::Error) diagnostics.error(each.location, each.message);
    }
    return nullptr;
  }
  Json bounces = Json::array();
  for (const transport::Truncation& truncation : job::truncate_paths(render_options, *job)) {
    const reflectance::Rgb& factor = truncation.last_bounce_factor;
    bounces.push_back({{"depth", truncation.depth},
                       {"bias", truncation.bias.error},
                       {"bias_interval", {truncation.bias.low, truncation.bias.high}},
                       {"last_bounce_factor", {factor.x, factor.y, factor.z}},
                       {"cost", number_or_null(truncation.cost(*render_options.target_error))}});
  }
  plan.depth = job->plan.depth;
  plan.why_depth = job->plan.why_depth;
  return {{"target", *render_options.target_error},
          {"bias_part", transport::BiasPart},
          {"depth", plan.depth},
          {"bounces", std::move(bounces)}};
}

void print_target_error(const Json& target) {
  fmt::print("target error {:.3g} %, of which the bias may be {:.3g} %: the bias of fewer bounces\n",
             100 * target["target"].get<double>(),
             100 * target["bias_part"].get<double>() * target["target"].get<double>());
  for (const Json& one : target["bounces"]) {
    const int depth = one["depth"].get<int>();
    fmt::print("{} depth {}: {:.2g} % (95 % interval {:.2g} to {:.2g} %){}\n",
               depth == target["depth"].get<int>() ? "+" : "-", depth, 100 * one["bias"].get<double>(),
               100 * one["bias_interval"][0].get<double>(), 100 * one["bias_interval"][1].get<double>(),
               one["cost"].is_null() ? "" : fmt::format(", {:.2f} of the rays", one["cost"].get<double>()));
  }
  if (target["bounces"].empty()) fmt::print("  all bounces are kept\n");
}

/// Adds what is measured to the report: all of it, unless a signal stops it.
void measure(const PlanArguments& arguments, const options::RenderOptions& render_options, const Plan& plan,
             Json& report, Diagnostics& diagnostics) {
  Json effects = Json::array();
  if (!arguments.images.empty()) {
    std::error_code ignored;  // writing to it reports the error
    std::filesystem::create_directories(arguments.images, ignored);
  }
  job::EffectMeasurement measurement(
      render_options, plan, arguments.measurement, [&](const job::MeasuredEffect& measured) {
        effects.push_back(json_of_effect(measured));
        if (!arguments.images.empty()) write_images(measured, arguments.images, diagnostics);
        if (arguments.progress != "json") return;
        fmt::print("{}\n", json_text(Json{{"measured", effects.back()}}, true));
        std::fflush(stdout);
      });
  SignalHandler signal_handler;
  run_watched(measurement, signal_handler, [] {});
  for (const grf::Diagnostic& each : measurement.diagnostics().entries()) {
    if (each.severity == grf::Severity::Error) diagnostics.error(each.location, each.message);
  }
  const options::ImageSize size = measurement.size();
  report["measurement"] = {{"width", size.width},
                           {"height", size.height},
                           {"seconds", arguments.measurement.seconds},
                           {"probability", 0.95},
                           {"complete", effects.size() == measurement.effect_count()},
                           {"effects", std::move(effects)}};
}

std::string percent_text(const Json& share) {
  if (share.is_null()) return "unknown";
  return fmt::format("{:.1f} % ({:.1f} to {:.1f})", 100 * share["share"].get<double>(),
                     100 * share["interval"][0].get<double>(), 100 * share["interval"][1].get<double>());
}

void print_measurement(const Json& measurement) {
  fmt::print("measured on {}x{} pixels, with 95 % intervals: what is lost without the effect\n",
             measurement["width"].get<int>(), measurement["height"].get<int>());
  fmt::print("  {:<24}{:<30}{:<30}{}\n", "", "light", "time", "difference");
  for (const Json& effect : measurement["effects"]) {
    const Json& difference = effect["difference"];
    fmt::print("  {:<24}{:<30}{:<30}{}\n", effect["name"].get<std::string>(), percent_text(effect["light"]),
               percent_text(effect["time"]),
               difference.is_null() ? "unknown" : fmt::format("{:.1f} %", 100 * difference.get<double>()));
  }
  if (!measurement["complete"].get<bool>()) fmt::print("  stopped: other effects were not measured\n");
}

}  // namespace

ExitCode plan(const PlanArguments& arguments) {
  Diagnostics diagnostics;
  auto render_options = read_options(arguments.scene, diagnostics);
  Json report;
  if (render_options) {
    if (!apply_flags(arguments.flags, *render_options)) return ExitCode::BadCommandLine;
    const auto compile_settings = job::compile_settings_of(*render_options, diagnostics);
    const auto scene = job::read_scene(*render_options, diagnostics);
    std::optional<job::RenderPlan> planned;
    if (scene && compile_settings) {
      planned = job::render_plan(*scene, *compile_settings, *render_options, diagnostics);
    }
    if (planned) {
      const Json target = target_error_of(*render_options, planned->plan, diagnostics);
      report = report_of(*scene, *planned, diagnostics);
      report["target_error"] = target;
    }
    if (planned && arguments.measures && diagnostics.error_count() == 0) {
      measure(arguments, *render_options, planned->plan, report, diagnostics);
    }
  }
  fmt::print(stderr, "{}", diagnostics.to_text());
  if (diagnostics.error_count() > 0) return ExitCode::BadInput;
  if (arguments.json) fmt::print("{}\n", json_text(report, arguments.progress == "json"));
  if (!arguments.json) print_text(report);
  if (!arguments.json && !report["target_error"].is_null()) print_target_error(report["target_error"]);
  if (!arguments.json && arguments.measures) print_measurement(report["measurement"]);
  return ExitCode::Done;
}

}  // namespace command
