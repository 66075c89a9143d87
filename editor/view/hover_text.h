#pragma once

#include <QString>

#include "editor/document/face_selection.h"

namespace editor {

/// Describes a face for the status line: its mesh, its number and its surface.
QString hover_text(const SceneObjects& objects, FaceId face);

}  // namespace editor
