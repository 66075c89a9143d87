#pragma once

#include <optional>
#include <string>
#include <vector>

namespace convert::vrml {

/// The first of the addresses that is of a file which is there, or else the first of one that could be: files
/// are named from the folder, and that from the folder of `main_path`. Nothing if all lie elsewhere, as
/// `http:` does. The name that comes back is from the folder of `main_path`.
std::optional<std::string> local_file(const std::vector<std::string>& addresses, const std::string& folder,
                                      const std::string& main_path);

/// The folder of a file, of which `name` says where it is.
std::string folder_of(const std::string& name);

}  // namespace convert::vrml
