// What the tests of the reader of VRML have in common.
#pragma once

#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "tests/converters/reading.h"

namespace convert {

/// Reads text from a file `model.wrl`, behind the first line of VRML97.
Reading read_vrml97(std::string_view text);

/// The same of VRML 1.0.
Reading read_vrml1(std::string_view text);

/// The only mesh of a text that is read without an error.
grf::Mesh mesh97(std::string_view text);
grf::Mesh mesh1(std::string_view text);

/// A shape of VRML97 with this geometry.
std::string shape(std::string_view geometry, std::string_view appearance = {});

/// An IndexedFaceSet of VRML97 with a square of two triangles, 0 1 2 and 0 2 3, and these fields.
std::string square(std::string_view fields = {});

/// The positions of a face's corners, in order.
std::vector<grf::Vec3f> corners_of(const grf::Mesh& mesh, std::size_t face);

/// The normals of a face's corners, in order; (0, 0, 0) where a corner has none.
std::vector<grf::Vec3f> normals_of(const grf::Mesh& mesh, std::size_t face);

inline const grf::Vec3f X(1, 0, 0);
inline const grf::Vec3f Y(0, 1, 0);
inline const grf::Vec3f Z(0, 0, 1);

/// The area of all faces together, and the sum of what they enclose: positive if their fronts are outside.
double area_of(const grf::Mesh& mesh);
double volume_of(const grf::Mesh& mesh);

}  // namespace convert
