// Helpers of the tests of the VRML reader.
#pragma once

#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "tests/converters/reading.h"

namespace convert {

/// Reads text from a file `model.wrl`, after the header line of VRML97.
Reading read_vrml97(std::string_view text);

/// Reads text likewise, after the header line of VRML 1.0.
Reading read_vrml1(std::string_view text);

/// Returns the only mesh of a valid text.
grf::Mesh mesh97(std::string_view text);
grf::Mesh mesh1(std::string_view text);

/// Makes a VRML97 Shape with this geometry.
std::string shape(std::string_view geometry, std::string_view appearance = {});

/// Makes a VRML97 IndexedFaceSet with a square of two triangles, 0 1 2 and 0 2 3, and these fields.
std::string square(std::string_view fields = {});

/// Returns the positions of a face's corners, in order.
std::vector<grf::Vec3f> corners_of(const grf::Mesh& mesh, std::size_t face);

/// Returns the normals of a face's corners, in order; (0, 0, 0) if a corner has none.
std::vector<grf::Vec3f> normals_of(const grf::Mesh& mesh, std::size_t face);

inline const grf::Vec3f X(1, 0, 0);
inline const grf::Vec3f Y(0, 1, 0);
inline const grf::Vec3f Z(0, 0, 1);

/// Computes the total area of all faces and the signed volume: positive if the fronts are outside.
double area_of(const grf::Mesh& mesh);
double volume_of(const grf::Mesh& mesh);

}  // namespace convert
