#pragma once

#include <optional>
#include <string>

#include "grf/diagnostics.h"
#include "grf/scene.h"

namespace editor {

/// Reads a scene or a model of any format, for figures of it. A damaged file can end the program: windows
/// read files with SceneLoader first, in a process of its own.
std::optional<grf::Scene> read_any_scene(const std::string& path, grf::Diagnostics& diagnostics);

}  // namespace editor
