// Objects and mesh definitions of a scene are dragged under a MIME type of their own.
#pragma once

#include <QMimeData>
#include <memory>
#include <vector>

#include "grf/scene_path.h"

namespace editor {

/// The MIME type of paths in the scene, one per line, with slashes between their indices. It is only of use
/// in the window that it is from.
inline constexpr const char* ObjectsMimeType = "application/x-granada-objects";

std::unique_ptr<QMimeData> mime_of(const std::vector<grf::ScenePath>& paths);
/// The paths in dragged data; empty without any.
std::vector<grf::ScenePath> paths_of(const QMimeData& mime);

}  // namespace editor
