#pragma once

#include "converters/ply/ply_header.h"
#include "converters/ply/ply_mesh.h"
#include "grf/diagnostics.h"

namespace convert {

/// Reads the body of any PLY file into a mesh. False after an error, which says the line and column of a
/// text, or the byte of a binary file. `end` becomes where the last element ends.
bool read_ply_elements(const PlySource& source, const PlyHeader& header, PlyMesh& mesh, std::size_t& end,
                       grf::Diagnostics& diagnostics);

}  // namespace convert
