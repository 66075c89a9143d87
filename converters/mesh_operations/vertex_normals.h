// Smooth vertex normals: each is the mean of the normals of the adjacent faces, weighted by their angles at
// the vertex (G. Thürmer and C. A. Wüthrich 1998, "Computing vertex normals from polygonal facets", Journal
// of Graphics Tools 3:1). Unlike area weights or uniform weights, these do not depend on the tessellation.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "grf/disjoint_sets.h"
#include "grf/geometry.h"

namespace convert {

/// Computes a polygon's contribution to the normal at each corner: its unit normal times its inner angle;
/// zero vectors if it is degenerate.
void weighted_normals(std::span<const std::uint32_t> face, std::span<const grf::Vec3f> positions,
                      std::vector<grf::Vec3d>& normals);

/// Normalizes a sum of weighted normals. Returns nothing if the faces are degenerate or back to back.
std::optional<grf::Vec3f> unit_normal(const grf::Vec3d& sum);

/// Smooth normals with creases.
struct CreasedNormals {
  grf::DisjointSets corners;     ///< corners in one set share a normal
  std::vector<grf::Vec3d> sums;  ///< sums of weighted normals, by the representative corner of a set

  std::optional<grf::Vec3f> at(std::uint32_t corner) { return unit_normal(sums[corners.set_of(corner)]); }
};

/// Computes normals that are smooth across each edge whose faces' normals differ by an angle of at most
/// `crease`, in radians. All edges of degenerate faces are creases. `places`: see `half_edges_of`.
CreasedNormals creased_normals(const grf::Geometry& geometry, std::span<const std::uint32_t> places,
                               double crease);

}  // namespace convert
