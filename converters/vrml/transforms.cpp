#include "converters/vrml/transforms.h"

namespace convert::vrml {

using grf::Matrix44d;
using grf::Vec3d;

Matrix44d rotation_of(std::span<const double> axis_and_angle) {
  Matrix44d matrix;
  if (axis_and_angle.empty()) return matrix;
  const Vec3d axis(axis_and_angle[0], axis_and_angle[1], axis_and_angle[2]);
  if (axis != Vec3d(0)) matrix.setAxisAngle(axis.normalized(), axis_and_angle[3]);
  return matrix;
}

Matrix44d matrix_of_transform(const NodeReader& node, std::string_view scale_field) {
  const auto moved = [](const Vec3d& by) { return Matrix44d().setTranslation(by); };
  const Vec3d center = node.triple("center", Vec3d(0));
  const Vec3d translation = node.triple("translation", Vec3d(0));
  const Matrix44d scale_axes = rotation_of(node.exactly("scaleOrientation", 4));
  const Matrix44d rotation = rotation_of(node.exactly("rotation", 4));
  const Matrix44d scale = Matrix44d().setScale(node.triple(scale_field, Vec3d(1)));
  // Row vectors: the first factor is applied first.
  return moved(-center) * scale_axes.transposed() * scale * scale_axes * rotation *
         moved(center + translation);
}

}  // namespace convert::vrml
