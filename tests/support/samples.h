#pragma once

#include <algorithm>
#include <array>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/support/paths.h"

namespace test {

inline std::filesystem::path samples_folder() {
  return std::filesystem::path(GRANADA_SOURCE_DIR) / "samples";
}

/// Returns whether a scene needs a mesh or tables that scripts/demo or samples/studies/thesis/run makes. The
/// files of the gallery are made by the tests' fixture `gallery`.
inline bool needs_made_files(const std::filesystem::path& path) {
  constexpr std::array Scenes = {"bunny/scene", "studies/thesis/dragon", "studies/thesis/measured"};
  const auto scene = std::filesystem::relative(path, samples_folder()).replace_extension();
  return std::ranges::find(Scenes, scene.generic_string()) != Scenes.end();
}

/// Returns all OP files whose scenes need no generated files.
inline std::vector<std::string> sample_op_files() {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(samples_folder())) {
    const bool is_whole = !needs_made_files(entry.path());
    if (entry.path().extension() == ".op" && is_whole) paths.push_back(entry.path().string());
  }
  if (paths.size() < 5) throw std::runtime_error("there are too few sample scenes");
  std::sort(paths.begin(), paths.end());
  return paths;
}

}  // namespace test
