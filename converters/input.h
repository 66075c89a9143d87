// A file of any format is read as a scene.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "converters/format.h"

namespace convert {

/// What to read, and how.
struct InputOptions {
  std::string path;
  const Format* format = nullptr;  ///< null: detected from content, then from the name
  ReadOptions reading;
};

/// What was read.
struct Input {
  const Format* format = nullptr;  ///< of the file
  Import import;
};

/// Reads a file and validates the scene against the catalogue of models. Returns nothing after an error.
std::optional<Input> read_input(const InputOptions& options, grf::Diagnostics& diagnostics);

/// Parses and validates the BRDF of an option.
std::optional<grf::BrdfModel> read_brdf_option(const std::string& text, const std::string& option,
                                               grf::Diagnostics& diagnostics);

}  // namespace convert
