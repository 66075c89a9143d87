#pragma once

#include <optional>

#include "grf/diagnostics.h"
#include "grf/model.h"
#include "renderer/options/render_options.h"

namespace options {

/// The sampling scheme that the options name, as a scene would write it, with the parameters that were given.
/// Nothing if they name none: each BRDF then has the scene's. Its locations are those of the options.
std::optional<grf::PdfModel> scheme_model(const RenderOptions& options);

/// Warns of options that were given and that no scheme in use looks at: those of other schemes than the one
/// that is named, and all where none is.
void warn_of_unused_options(const RenderOptions& options, grf::Diagnostics& diagnostics);

}  // namespace options
