#include "renderer/command/plan_summary.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "grf/text_file.h"
#include "grf/wording.h"

namespace command {
namespace {

nlohmann::json entry(const std::string& name, const std::string& why) {
  return {{"name", name}, {"why", why}};
}

/// Sums the sizes of the textures that are left out; missing files count as 0.
std::uintmax_t left_out_texture_bytes(const plan::Plan& plan) {
  std::uintmax_t sum = 0;
  for (const plan::PlannedTexture& texture : plan.textures) {
    std::error_code missing;
    const std::uintmax_t bytes = texture.is_needed ? 0 : std::filesystem::file_size(texture.file, missing);
    sum += missing ? 0 : bytes;
  }
  return sum;
}

}  // namespace

void add_plan(const plan::Plan& plan, nlohmann::json& summary) {
  nlohmann::json effects = nlohmann::json::array();
  nlohmann::json left_out = nlohmann::json::array();
  for (const plan::PlannedEffect& effect : plan.effects) {
    const std::string name(name_of(effect.effect));
    if (effect.is_needed) effects.push_back(name);
    if (!effect.is_needed) left_out.push_back(entry(name, effect.why));
  }
  for (const plan::PlannedTable& table : plan.tables) {
    if (!table.is_needed)
      left_out.push_back(entry("table of " + table.brdf + " for " + table.scheme, table.why));
  }
  for (const plan::PlannedTexture& texture : plan.textures) {
    if (!texture.is_needed) left_out.push_back(entry("texture " + grf::file_name(texture.file), texture.why));
  }
  if (plan.depth < plan.asked_depth) {
    left_out.push_back(
        entry(fmt::format("bounces {} to {}", plan.depth + 1, plan.asked_depth), plan.why_depth));
  }
  summary["effects"] = std::move(effects);
  summary["left_out"] = std::move(left_out);
  const auto is_left_out = [](const plan::PlannedTable& table) { return !table.is_needed; };
  summary["saved"] = {{"tables", std::count_if(plan.tables.begin(), plan.tables.end(), is_left_out)},
                      {"texture_file_bytes", left_out_texture_bytes(plan)},
                      {"scatterings", plan.asked_depth - plan.depth}};
}

std::string left_out_line(const nlohmann::json& summary) {
  std::vector<std::string> names;
  for (const nlohmann::json& one : summary["left_out"]) names.push_back(one["name"]);
  if (names.empty()) return "nothing left out";
  const nlohmann::json& saved = summary["saved"];
  return fmt::format("left out: {}; this saved {}, {} of texture files and {} per path",
                     fmt::join(names, ", "),
                     grf::counted(saved["tables"].get<std::size_t>(), "table", "tables"),
                     grf::counted(saved["texture_file_bytes"].get<std::size_t>(), "byte", "bytes"),
                     grf::counted(saved["scatterings"].get<std::size_t>(), "bounce", "bounces"));
}

}  // namespace command
