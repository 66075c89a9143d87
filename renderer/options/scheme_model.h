#pragma once

#include <optional>

#include "grf/diagnostics.h"
#include "grf/model.h"
#include "renderer/options/render_options.h"

namespace options {

/// Returns the sampling scheme that the options name, as a PDF of a scene, with the parameters that were
/// given and the options' source locations. Nothing if they name none: each BRDF then has the scene's scheme.
std::optional<grf::PdfModel> scheme_model(const RenderOptions& options);

/// Returns why an option has no effect in combination with the others; nothing if it has one.
std::optional<std::string> why_unused(const RenderOptions& options, const OptionInfo& option);

/// Warns of options that differ from their defaults and have no effect, such as those of schemes that are not
/// used.
void warn_of_unused_options(const RenderOptions& options, grf::Diagnostics& diagnostics);

}  // namespace options
