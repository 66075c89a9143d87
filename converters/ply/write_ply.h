#pragma once

#include <string>

#include "grf/diagnostics.h"
#include "grf/scene.h"

namespace convert {

/// Replaces the file by the whole scene as one mesh that stands in the world, binary and little-endian, or
/// leaves it as it was and says why. What PLY cannot keep is said, one warning a kind.
///
/// Colours are bytes where those keep them exactly, else floats. A vertex without a normal gets one of no
/// length where others have one, which `read_ply` takes back; a missing colour is 1, a missing uv (0,0).
/// Names of materials stand in comments, `comment material 0 NAME`, to which the faces' `material_index`
/// refers.
bool write_ply(const grf::Scene& scene, const std::string& path, grf::Diagnostics& diagnostics);

/// The same as text, with the fewest digits that read back to the same float.
bool write_ply_ascii(const grf::Scene& scene, const std::string& path, grf::Diagnostics& diagnostics);

}  // namespace convert
