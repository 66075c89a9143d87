#pragma once

#include <string>

#include "editor/brdf/lobe_curves.h"
#include "editor/brdf/made_brdf.h"
#include "tests/editor/scene_of.h"

namespace editor {

/// The BRDF of GRF text, made to be evaluated.
inline SharedBrdf made_brdf_of(const std::string& text) { return made_brdf(brdf_model(text), {}).brdf; }

}  // namespace editor
