#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "converters/format.h"

namespace convert {

/// Embedded files of an input that were extracted beside the output.
struct WrittenFiles {
  std::vector<std::string> paths;            ///< paths of all files, in order
  std::vector<std::string> created;          ///< paths of files that did not exist before
  std::map<std::string, std::string> names;  ///< the name of each file on disk, by its embedded name
};

/// Writes the files into the folder of `output`. Existing files stay unchanged: one with the same bytes is
/// reused, and next to a different one the file gets a free name. After an error nothing is returned and all
/// created files are removed.
std::optional<WrittenFiles> write_embedded_files(std::span<const EmbeddedFile> files,
                                                 const std::string& output, grf::Diagnostics& diagnostics);

/// Removes the created files, if the file that names them could not be written.
void remove_created(const WrittenFiles& files);

}  // namespace convert
