#pragma once

#include <optional>

#include "grf/diagnostics.h"
#include "grf/model.h"
#include "renderer/options/render_options.h"

namespace options {

/// The sampling scheme that the options name, as a scene would write it, with the parameters that were given.
/// Nothing if they name none: each BRDF then has the scene's. Its locations are those of the options.
std::optional<grf::PdfModel> scheme_model(const RenderOptions& options);

/// Why an option has no effect while the others are as they are, given or not; nothing if it has one.
std::optional<std::string> why_unused(const RenderOptions& options, const OptionInfo& option);

/// Warns of options that are not at their defaults and have no effect, such as those of other schemes than
/// the one that is named.
void warn_of_unused_options(const RenderOptions& options, grf::Diagnostics& diagnostics);

}  // namespace options
