// Face loops run across opposite edges of quadrilaterals, as in the face mode of modelling programs.
#pragma once

#include <cstdint>

#include "editor/document/face_selection.h"

namespace editor {

/// The quadrilaterals on both sides of an edge, and those beyond their opposite edges, and so on. The loop
/// closes, or ends at other polygons, at the border and at edges of more than two faces. The edge begins at
/// a corner of the face, from 0. Empty if no face at the edge is a quadrilateral.
FaceSelection face_loop(const SceneObjects& objects, FaceId face, std::uint32_t corner);

/// The loop through the same face that crosses its `face_loop`: across the next edge.
FaceSelection crossing_face_loop(const SceneObjects& objects, FaceId face, std::uint32_t corner);

}  // namespace editor
