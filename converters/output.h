// A scene is written in any format, with the files that its input embeds.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "converters/embedded_files.h"
#include "converters/format.h"

namespace convert {

/// Where to write, and how.
struct OutputOptions {
  std::string path;
  const Format* format = nullptr;  ///< one that is written
  WriteOptions writing;
  bool grf2008 = false;  ///< write only the grammar of 2008, of a GRF file
};

/// Writes a scene whose file names are relative to the file `from`, and the embedded files of that file
/// beside the output: names in the scene become relative to the output. Returns nothing, with no file left,
/// after an error.
std::optional<WrittenFiles> write_output(grf::Scene& scene, std::span<const EmbeddedFile> embedded,
                                         const std::string& from, const OutputOptions& options,
                                         grf::Diagnostics& diagnostics);

}  // namespace convert
