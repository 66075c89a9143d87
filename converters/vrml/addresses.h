#pragma once

#include <optional>
#include <string>
#include <vector>

namespace convert::vrml {

/// Returns the first URL of an existing local file, or else the first URL of a possible local file. Files are
/// relative to the folder, which is relative to the folder of `main_path`. Nothing if all are remote, such as
/// `http:`. The name returned is relative to the folder of `main_path`.
std::optional<std::string> local_file(const std::vector<std::string>& addresses, const std::string& folder,
                                      const std::string& main_path);

/// Returns the folder part of a file name.
std::string folder_of(const std::string& name);

}  // namespace convert::vrml
