// What a plan leaves out, in words and as JSON.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "renderer/transport/plan/plan.h"

namespace command {

/// Adds `effects`, the names of those in use, and `left_out`: what the scene or the options name and the
/// render does without, as name and why.
void add_plan(const transport::Plan& plan, nlohmann::json& summary);

/// The names of `left_out`, of a summary that has it.
std::string left_out_line(const nlohmann::json& summary);

}  // namespace command
