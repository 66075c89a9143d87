// What a plan leaves out, in words and as JSON.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "renderer/transport/plan/plan.h"

namespace command {

/// Adds `effects`, the names of those in use; `left_out`, what the render does without, as name and why; and
/// `saved`, what that comes to. How large a table would be is known once it is made: `bpt plan` does that.
void add_plan(const transport::Plan& plan, nlohmann::json& summary);

/// The names of `left_out` and what is in `saved`, of a summary that has them.
std::string left_out_line(const nlohmann::json& summary);

}  // namespace command
