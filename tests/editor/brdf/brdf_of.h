#pragma once

#include <string>

#include "editor/brdf/lobe_curves.h"
#include "editor/brdf/made_brdf.h"
#include "tests/editor/scene_of.h"

namespace editor {

/// Compiles the BRDF of GRF text.
inline SharedBrdf made_brdf_of(const std::string& text) { return made_brdf(brdf_model(text), {}).brdf; }

}  // namespace editor
