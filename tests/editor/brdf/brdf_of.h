#pragma once

#include <string>

#include "editor/brdf/compiled_brdf.h"
#include "editor/brdf/lobe_curves.h"
#include "tests/editor/scene_of.h"

namespace editor {

/// Compiles the BRDF of GRF text.
inline SharedBrdf compiled_brdf_of(const std::string& text) {
  return compile_brdf(brdf_model(text), {}).brdf;
}

}  // namespace editor
