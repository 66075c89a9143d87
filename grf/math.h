// Imath is the vector library of the whole project; its vectors, matrices and boxes have short names here.
#pragma once

#include <ImathBox.h>
#include <ImathMatrix.h>
#include <ImathVec.h>

namespace grf {

using Vec2f = Imath::V2f;
using Vec3f = Imath::V3f;
using Vec2d = Imath::V2d;
using Vec3d = Imath::V3d;
using Box3f = Imath::Box3f;
using Box3d = Imath::Box3d;

/// Matrices use Imath's row-vector convention: a point is transformed by `point * matrix`, and `a * b`
/// applies a first, then b.
using Matrix44d = Imath::M44d;
using Matrix33f = Imath::M33f;

/// Linear RGB. Reflectances are 0..1, radiances W/(sr m2) and >= 0.
using Colour = Imath::V3f;

}  // namespace grf
