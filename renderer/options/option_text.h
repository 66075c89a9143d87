#pragma once

#include <string>

#include "renderer/options/render_options.h"

namespace options {

/// The value of an option as an OP file would give it, exactly; empty for one that was not given.
std::string option_text(const RenderOptions& options, const OptionInfo& option);

}  // namespace options
