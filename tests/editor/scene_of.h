#pragma once

#include <stdexcept>
#include <string>

#include "grf/read.h"

namespace editor {

/// The scene that a text is.
inline grf::Scene scene_of(const std::string& text) {
  grf::Diagnostics diagnostics;
  auto scene = grf::read_text(text, "scene.grf", diagnostics);
  if (!scene) throw std::runtime_error(diagnostics.to_text());
  return std::move(*scene);
}

}  // namespace editor
