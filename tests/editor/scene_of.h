#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include "grf/read.h"

namespace editor {

/// Reads a scene from GRF text; throws the diagnostics after an error.
inline grf::Scene scene_of(const std::string& text) {
  grf::Diagnostics diagnostics;
  auto scene = grf::read_text(text, "scene.grf", diagnostics);
  if (!scene) throw std::runtime_error(diagnostics.to_text());
  return std::move(*scene);
}

/// Reads a BRDF from GRF text; throws the diagnostics after an error.
inline grf::BrdfModel brdf_model(const std::string& text) {
  grf::Diagnostics diagnostics;
  auto model = grf::read_brdf(text, "test", diagnostics);
  if (!model) throw std::runtime_error(diagnostics.to_text());
  return std::move(*model);
}

}  // namespace editor
