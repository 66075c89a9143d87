#pragma once

#include <algorithm>
#include <array>
#include <filesystem>

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

}  // namespace test
