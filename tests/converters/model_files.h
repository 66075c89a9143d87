#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace convert {

// The models of Debian's packages assimp-testmodels and glmark2-data, whatever their names: formats are
// detected by content first.

inline const std::string AssimpModels = "/usr/share/assimp/models/";
inline const std::string Glmark2Models = "/usr/share/glmark2/models/";

/// The formats that have a suite of model tests. Files of other formats would not be tested.
const std::set<std::string_view>& formats_of_obj_models();
const std::set<std::string_view>& formats_of_ply_models();
const std::set<std::string_view>& formats_of_gltf_models();
const std::set<std::string_view>& formats_of_vrml_models();
const std::set<std::string_view>& formats_of_assimp_models();

/// Returns the sorted paths of all files of some formats.
std::vector<std::string> model_files(const std::set<std::string_view>& formats);

/// Returns a path relative to the package's folder.
std::string short_name(const std::string& path);

/// Converts a name to one that GoogleTest allows.
std::string test_name(const std::string& path);

}  // namespace convert
