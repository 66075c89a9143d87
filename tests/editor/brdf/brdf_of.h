#pragma once

#include <stdexcept>
#include <string>

#include "editor/brdf/made_brdf.h"
#include "grf/diagnostics.h"
#include "grf/read.h"

namespace editor {

/// The BRDF of GRF text; throws the diagnostics if there is an error in it.
inline grf::BrdfModel brdf_model(const std::string& text) {
  grf::Diagnostics diagnostics;
  auto model = grf::read_brdf(text, "test", diagnostics);
  if (!model) throw std::runtime_error(diagnostics.to_text());
  return *model;
}

/// The same, made to be evaluated.
inline SharedBrdf made_brdf_of(const std::string& text) { return made_brdf(brdf_model(text), {}).brdf; }

}  // namespace editor
