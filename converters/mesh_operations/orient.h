#pragma once

#include <vector>

#include "grf/geometry.h"
#include "grf/mesh.h"

namespace convert {

/// Which side of a part with boundary edges is outward.
enum class OpenParts {
  ByVolume,    ///< as for a closed part
  ByMajority,  ///< most of the area keeps its orientation, since a bowl or a backdrop may show its inside
};

/// Finds the faces that have to be reversed so that the faces of each connected part agree in their
/// orientation and point outward. Parts are connected at edges of two faces. Outward is where the signed
/// volume about the part's centre is positive; if that is about zero, as for a flat part, most of the area
/// keeps its orientation.
std::vector<bool> inward_faces(const grf::SharedGeometry& geometry,
                               OpenParts open_parts = OpenParts::ByVolume);

/// Reverses these faces, and the normals of vertices that then point to the backs of their faces.
grf::Mesh oriented_outward(const grf::Mesh& mesh);

}  // namespace convert
