// Reading GRF text into a scene.
#pragma once

#include <optional>
#include <string>

#include "grf/diagnostics.h"
#include "grf/scene.h"

namespace grf {

/// Reads a GRF file and the files that it includes. If there is any error, all that were found are in the
/// diagnostics and nothing is returned; warnings may be there either way.
std::optional<Scene> read(const std::string& path, Diagnostics& diagnostics);

/// The same for text that is at hand; the path stands for it in messages, and includes are beside it.
std::optional<Scene> read_text(std::string text, const std::string& path, Diagnostics& diagnostics);

/// A BRDF as it stands after the word `brdf`: a keyword and values, such as `ward sx=0.2 ks=0.4`.
/// The name stands for the text in messages.
std::optional<BrdfModel> read_brdf(std::string text, const std::string& name, Diagnostics& diagnostics);

/// A sampling scheme likewise, as it stands after the word `pdf`.
std::optional<PdfModel> read_pdf(std::string text, const std::string& name, Diagnostics& diagnostics);

}  // namespace grf
