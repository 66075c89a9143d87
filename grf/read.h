// Functions that read GRF text into a scene.
#pragma once

#include <optional>
#include <string>

#include "grf/diagnostics.h"
#include "grf/scene.h"

namespace grf {

/// Reads a GRF file and the files that it includes. After an error nothing is returned, and the diagnostics
/// have all errors that were found; they may have warnings either way.
std::optional<Scene> read(const std::string& path, Diagnostics& diagnostics);

/// Reads a scene from text; messages name the path, and includes are relative to it.
std::optional<Scene> read_text(std::string text, const std::string& path, Diagnostics& diagnostics);

/// Reads a BRDF as written after the keyword `brdf`: a model and values, such as `ward sx=0.2 ks=0.4`.
/// Messages use the name for the text.
std::optional<BrdfModel> read_brdf(std::string text, const std::string& name, Diagnostics& diagnostics);

/// Reads a sampling scheme likewise, as written after the keyword `pdf`.
std::optional<PdfModel> read_pdf(std::string text, const std::string& name, Diagnostics& diagnostics);

}  // namespace grf
