// Smooth normals at vertices. Each is the mean of the normals of the faces that meet there, weighted by their
// angles at the vertex (G. Thürmer and C. A. Wüthrich 1998, "Computing vertex normals from polygonal facets",
// Journal of Graphics Tools 3:1). Unlike weights by area, or none, these do not depend on how a surface is
// cut into faces.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "grf/disjoint_sets.h"
#include "grf/geometry.h"

namespace convert {

/// The unit normal of a polygon times its inner angle, at each corner: what it adds to the normals there.
/// Zero vectors if the polygon has no area.
void weighted_normals(std::span<const std::uint32_t> face, std::span<const grf::Vec3f> positions,
                      std::vector<grf::Vec3d>& normals);

/// The sum of weighted normals, made a unit vector. Nothing is returned where faces have no area, or are back
/// to back.
std::optional<grf::Vec3f> unit_normal(const grf::Vec3d& sum);

/// Normals that are smooth but for creases.
struct CreasedNormals {
  grf::DisjointSets corners;     ///< those in one set share a normal
  std::vector<grf::Vec3d> sums;  ///< of weighted normals, at the corner that stands for its set

  std::optional<grf::Vec3f> at(std::uint32_t corner) { return unit_normal(sums[corners.set_of(corner)]); }
};

/// Normals that are smooth across each edge whose faces are turned against each other by an angle of at most
/// `crease`, in radians. Faces without area have creases all round. `places`: see `edges_of_faces`.
CreasedNormals creased_normals(const grf::Geometry& geometry, std::span<const std::uint32_t> places,
                               double crease);

}  // namespace convert
