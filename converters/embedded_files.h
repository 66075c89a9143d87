#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "converters/format.h"

namespace convert {

/// Files that stood inside another one, written beside what is made of that.
struct WrittenFiles {
  std::vector<std::string> paths;            ///< of all, in their order
  std::vector<std::string> created;          ///< those that were not there before
  std::map<std::string, std::string> names;  ///< under which each stands there, by its own name
};

/// Writes the files into the folder of `output`. A file that is there already stays as it is: one with the
/// same bytes is taken for the file itself, and beside another one the file gets a name that is free. Nothing
/// is returned after an error, and nothing is left then.
std::optional<WrittenFiles> write_embedded_files(std::span<const EmbeddedFile> files,
                                                 const std::string& output, grf::Diagnostics& diagnostics);

/// Takes back what was created, where the file that names it could not be written.
void remove_created(const WrittenFiles& files);

}  // namespace convert
