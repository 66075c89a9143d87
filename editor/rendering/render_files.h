// The scene of a final render, as `bpt` reads it.
#pragma once

#include <QString>

#include "grf/diagnostics.h"
#include "grf/scene.h"

namespace editor {

/// The absolute path from which a scene names other files; one that has no file does so from the current
/// folder.
QString naming_path(const QString& scene_path);

/// Writes a scene as it is in memory to one file, whatever it includes, with all files named from there.
/// False after an error.
bool write_snapshot(const grf::Scene& scene, const QString& scene_path, const QString& path,
                    grf::Diagnostics& diagnostics);

}  // namespace editor
