#pragma once

#include "converters/ply/ply_header.h"
#include "converters/ply/ply_mesh.h"
#include "grf/diagnostics.h"

namespace convert {

/// Reads the body of any PLY file into a mesh. Returns false after an error, which has the line and column of
/// a text, or the byte offset of a binary file. Sets `end` to the end of the last element.
bool read_ply_elements(const PlySource& source, const PlyHeader& header, PlyMesh& mesh, std::size_t& end,
                       grf::Diagnostics& diagnostics);

}  // namespace convert
