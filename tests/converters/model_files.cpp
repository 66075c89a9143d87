#include "tests/converters/model_files.h"

#include <algorithm>
#include <filesystem>

#include "converters/format.h"
#include "grf/keywords.h"

namespace convert {

using Formats = std::set<std::string_view>;

const Formats& formats_of_obj_models() {
  static const Formats formats = {"obj"};
  return formats;
}

const Formats& formats_of_ply_models() {
  static const Formats formats = {"ply"};
  return formats;
}

const Formats& formats_of_gltf_models() {
  static const Formats formats = {"gltf", "glb"};
  return formats;
}

const Formats& formats_of_vrml_models() {
  static const Formats formats = {"vrml"};
  return formats;
}

const Formats& formats_of_assimp_models() {
  static const Formats formats = {"3ds", "stl", "off", "dxf", "collada", "fbx", "lwo", "ac3d", "x", "other"};
  return formats;
}

std::vector<std::string> model_files(const Formats& formats) {
  std::vector<std::string> paths;
  for (const std::string& folder : {AssimpModels, Glmark2Models}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
      if (!entry.is_regular_file()) continue;
      grf::Diagnostics diagnostics;
      const Format* format = recognise(entry.path().string(), diagnostics);
      if (format != nullptr && formats.contains(format->name)) paths.push_back(entry.path().string());
    }
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

std::string short_name(const std::string& path) {
  return path.substr((path.starts_with(AssimpModels) ? AssimpModels : Glmark2Models).size());
}

std::string test_name(const std::string& path) {
  std::string name = short_name(path);
  const auto is_of_no_name = [](char c) { return !grf::is_word_character(c) || c == '$'; };
  std::replace_if(name.begin(), name.end(), is_of_no_name, '_');
  return name;
}

}  // namespace convert
