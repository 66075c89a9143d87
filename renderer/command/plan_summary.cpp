#include "renderer/command/plan_summary.h"

#include <filesystem>
#include <vector>

#include <fmt/format.h>

namespace command {
namespace {

nlohmann::json entry(const std::string& name, const std::string& why) {
  return {{"name", name}, {"why", why}};
}

std::string file_name(const std::string& path) { return std::filesystem::path(path).filename().string(); }

}  // namespace

void add_plan(const transport::Plan& plan, nlohmann::json& summary) {
  nlohmann::json effects = nlohmann::json::array();
  nlohmann::json left_out = nlohmann::json::array();
  for (const transport::PlannedEffect& effect : plan.effects) {
    const std::string name(name_of(effect.effect));
    if (effect.is_needed) effects.push_back(name);
    if (!effect.is_needed) left_out.push_back(entry(name, effect.why));
  }
  for (const transport::PlannedTable& table : plan.tables) {
    if (!table.is_needed)
      left_out.push_back(entry("table of " + table.brdf + " for " + table.scheme, table.why));
  }
  for (const transport::PlannedTexture& texture : plan.textures) {
    if (!texture.is_needed) left_out.push_back(entry("texture " + file_name(texture.file), texture.why));
  }
  if (plan.depth < plan.asked_depth) {
    left_out.push_back(
        entry(fmt::format("scatterings {} to {}", plan.depth + 1, plan.asked_depth), plan.why_depth));
  }
  summary["effects"] = std::move(effects);
  summary["left_out"] = std::move(left_out);
}

std::string left_out_line(const nlohmann::json& summary) {
  std::vector<std::string> names;
  for (const nlohmann::json& one : summary["left_out"]) names.push_back(one["name"]);
  return names.empty() ? "nothing left out" : fmt::format("left out: {}", fmt::join(names, ", "));
}

}  // namespace command
