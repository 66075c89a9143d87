// Edits the steps of a transform such that edits and their inverses restore the same numbers.
#pragma once

#include <vector>

#include "grf/math.h"
#include "grf/scene.h"

namespace editor {

using TransformSteps = std::vector<grf::TransformStep>;

/// Position, rotation and scale of an object in the space of its parent: scaled first, then rotated about x,
/// y and z in this order, then translated.
struct ObjectTransform {
  grf::Vec3d position = grf::Vec3d(0);
  grf::Vec3d rotation = grf::Vec3d(0);  ///< degrees
  grf::Vec3d scale = grf::Vec3d(1);     ///< none is 0
  /// Whether the steps shear, as a scale after a rotation does. Rotation and scale are then approximations.
  bool has_shear = false;
};

/// Decomposes the steps of a transform.
ObjectTransform object_transform_of(const TransformSteps& steps);
/// Returns the steps of a transform; empty for the identity. Shear is ignored.
TransformSteps steps_of(const ObjectTransform& transform);

// Each of these appends an action in the parent's space to the steps, merged into the last steps where these
// are of its kind, so that their number stays below a bound. Numbers with few decimals stay such numbers:
// sums of translations are exact in decimals, and those of rotations in 1/10000 degree, so that equal edits
// forth and back give the same steps. Where a step cannot hold the exact result a second one is added. Steps
// without effect are removed.

void translate(TransformSteps& steps, const grf::Vec3d& offset);
/// Rotates about an axis of any length through the pivot, counter-clockwise seen from its tip.
void rotate(TransformSteps& steps, const grf::Vec3d& axis, double degrees, const grf::Vec3d& pivot);
/// Scales about the pivot, by a factor along each row of `axes`, which is orthonormal. No factor is 0.
void scale(TransformSteps& steps, const grf::Vec3d& factors, const grf::Matrix44d& axes,
           const grf::Vec3d& pivot);
/// Appends any affine action, given as a matrix; its result is rounded to `float`.
void transform(TransformSteps& steps, const grf::Matrix44d& action);

/// Returns the number with the fewest significant digits, 6 at most, within a tolerance; the number itself if
/// there is none.
double shortest_near(double number, double tolerance);

}  // namespace editor
