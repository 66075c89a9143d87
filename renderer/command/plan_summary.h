// A render plan is summarised as text and as JSON.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "renderer/plan/plan.h"

namespace command {

/// Adds to a JSON summary: `effects`, the names of the effects in use; `left_out`, with name and why; and
/// `saved`, the cost of those. The size of tables is unknown until they are built, as `bpt plan` does.
void add_plan(const plan::Plan& plan, nlohmann::json& summary);

/// Formats `left_out` and `saved` of a summary as one line of text.
std::string left_out_line(const nlohmann::json& summary);

}  // namespace command
