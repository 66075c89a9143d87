#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace convert {

// What comes with Debian's packages assimp-testmodels and glmark2-data, whatever the names: of which format a
// file is, its content says first.

inline const std::string AssimpModels = "/usr/share/assimp/models/";
inline const std::string Glmark2Models = "/usr/share/glmark2/models/";

/// The formats that the tests of models take, one suite each. What is of none would be tested by nobody.
const std::set<std::string_view>& formats_of_obj_models();
const std::set<std::string_view>& formats_of_ply_models();
const std::set<std::string_view>& formats_of_gltf_models();
const std::set<std::string_view>& formats_of_vrml_models();
const std::set<std::string_view>& formats_of_assimp_models();

/// The paths of all files of some formats, sorted.
std::vector<std::string> model_files(const std::set<std::string_view>& formats);

/// A path without the package's folder.
std::string short_name(const std::string& path);

/// The name as GoogleTest allows it.
std::string test_name(const std::string& path);

}  // namespace convert
