#pragma once

#include <optional>
#include <string>
#include <vector>

#include "converters/format.h"

namespace convert {

struct InputOptions {
  std::string path;
  const Format* format = nullptr;  ///< null: told by content, then by name
  ReadOptions reading;
};

struct Input {
  const Format* format = nullptr;
  grf::Scene scene;
  std::vector<EmbeddedFile> files;
};

/// Reads a file and checks the scene against the models that there are. Nothing is returned after an error.
std::optional<Input> read_input(const InputOptions& options, grf::Diagnostics& diagnostics);

/// The BRDF that an option gives, checked as one of a scene.
std::optional<grf::BrdfModel> read_brdf_option(const std::string& text, const std::string& option,
                                               grf::Diagnostics& diagnostics);

}  // namespace convert
