// The reading of PLY files by OpenMesh, for the common ones.
//
// OpenMesh 9 reads the body of a PLY file as its header says, but passes over what it cannot make sense of,
// and hands colours over as bytes. So it reads the files of which the header shows that it takes them over
// bit for bit; all others are read by `read_ply_elements`:
//
// - there are the elements `vertex` and `face`, in this order, and no other: it stops behind the faces;
// - x, y, z, nx, ny, nz, u, v (or s, t) of vertices are floats of 32 bits: it reads a double as 0;
// - red, green, blue, alpha are bytes: it rounds floats to bytes;
// - faces begin with the list `vertex_indices` (or `vertex_index`) of 32 bits, counted by a byte: it believes
//   any count, and so a large one can take all memory;
// - there is no other list: it would read one value of it;
// - faces have no material, texture or texture coordinates, which it keeps to itself;
// - the header is plain: it loses count of the bytes behind a comment or a space before `end_header`.
#pragma once

#include <cstddef>

#include "converters/ply/ply_header.h"
#include "converters/ply/ply_mesh.h"

namespace convert {

/// Whether OpenMesh takes over all that the file has.
bool openmesh_reads(const PlyHeader& header);

/// Reads such a file into the mesh. False if the body is broken: OpenMesh does not say where, but
/// `read_ply_elements` does, into another mesh. `end` becomes where the last face ends.
bool read_ply_by_openmesh(const PlySource& source, const PlyHeader& header, PlyMesh& mesh, std::size_t& end);

}  // namespace convert
