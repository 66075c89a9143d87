#pragma once

#include <string>

#include "grf/diagnostics.h"
#include "grf/scene.h"

namespace convert {

/// Writes the whole scene as one world-space mesh in binary little-endian PLY, or leaves the file unchanged
/// and reports why. Losses are reported in one warning per kind.
///
/// Colours are bytes if that is exact, else floats. A vertex without a normal gets a zero normal if others
/// have one, which `read_ply` reads as none; a missing colour is 1, a missing uv (0,0). Names of materials
/// are in comments, `comment material 0 NAME`, which the faces' `material_index` refers to.
bool write_ply(const grf::Scene& scene, const std::string& path, grf::Diagnostics& diagnostics);

/// Writes PLY as text, with the fewest digits that read back to the same float.
bool write_ply_ascii(const grf::Scene& scene, const std::string& path, grf::Diagnostics& diagnostics);

/// Writes one mesh, untransformed, as binary PLY for a renderer: colours of its vertices are always floats,
/// since renderers take bytes as sRGB-encoded. Attributes of its surfaces are not written.
bool write_ply_mesh(const grf::Mesh& mesh, const std::string& path, grf::Diagnostics& diagnostics);

}  // namespace convert
