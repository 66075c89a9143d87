// Risks of a mesh are found in its own coordinates.
#pragma once

#include <cstdint>
#include <vector>

#include "grf/mesh.h"

namespace convert {

// Each returns indices of faces, ascending.

/// Finds faces whose area is under 1e-7 of their longest edge squared: that is rounding.
std::vector<std::uint32_t> faces_without_area(const grf::Mesh& mesh);

/// Finds faces with the corners of an earlier face at the same positions, in the same order: the first of
/// them is not listed. A face with the opposite orientation is no duplicate, since it is the back of a sheet.
std::vector<std::uint32_t> duplicate_faces(const grf::Mesh& mesh);

/// Finds faces whose vertices all have normals, which all point to the back of the face.
std::vector<std::uint32_t> faces_against_normals(const grf::Mesh& mesh);

/// Finds textured faces with an area whose texture coordinates have none: under 1e-10 of an image whose sides
/// are 1. Corners without texture coordinates have (0,0).
std::vector<std::uint32_t> faces_without_uv_area(const grf::Mesh& mesh);

/// Computes the winding number of a closed mesh about a point: 1 inside of a surface whose fronts point
/// outward, 0 outside (A. Jacobson, L. Kavan and O. Sorkine-Hornung 2013, "Robust inside-outside segmentation
/// using generalized winding numbers"; solid angles by A. van Oosterom and J. Strackee 1983).
double winding_number(const grf::SharedGeometry& geometry, const grf::Vec3d& point);

}  // namespace convert
