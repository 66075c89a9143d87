#include "renderer/transport/lights/spherical_triangle.h"

#include <algorithm>
#include <cmath>

namespace transport {

float angle_of(double y, double x) {
  const double larger = std::max(std::abs(x), std::abs(y));
  if (!(larger > 0)) return 0;
  return std::atan2(static_cast<float>(y / larger), static_cast<float>(x / larger));
}

namespace {

double half_square(const Vec3d& v) { return v.dot(v) / 2; }

}  // namespace

SphericalTriangle::SphericalTriangle(const Vec3d& pivot, const Vec3d& first, const Vec3d& last,
                                     double volume) {
  const Vec3d lengths(std::sqrt(pivot.dot(pivot)), std::sqrt(first.dot(first)), std::sqrt(last.dot(last)));
  const double product = lengths.x * lengths.y * lengths.z;
  if (!(volume > 0) || !(product > 0)) return;
  inverse_lengths_ = {1 / lengths.x, 1 / lengths.y, 1 / lengths.z};
  pivot_ = pivot * inverse_lengths_.x;
  first_ = first * inverse_lengths_.y;
  last_ = last * inverse_lengths_.z;
  const Vec3d half = first_ + last_;
  pivot_first_sum_ = half_square(pivot_ + first_);
  first_last_sum_ = half_square(half);
  volume_ = volume / product;
  sum_ = first_last_sum_ + pivot_.dot(half);
  solid_angle_ = 2 * angle_of(volume_, sum_);
}

SphericalTriangle::SphericalTriangle(const Vec3d& corner, const Vec3d& edge1, const Vec3d& edge2)
    : SphericalTriangle(corner, corner + edge1, corner + edge2, -edge1.cross(edge2).dot(corner)) {}

Vec3d SphericalTriangle::weights(float part, float xi) const {
  // The arc's point is the first corner mirrored at p first + q last. From a point that touches the triangle,
  // corners or the pivot and the arc are opposite, and p - q and sums of vectors carry the accuracy.
  const double sine = std::sin(part / 2);
  const double difference = std::max(0.0, volume_ * std::cos(part / 2) - sum_ * sine);
  const double q = pivot_first_sum_ * sine;
  const double p = q + difference;
  const double length2 = difference * difference + 2 * p * q * first_last_sum_;
  double x = 1;
  double y = 0;
  if (length2 > 0) {
    x = difference * (p + q) / length2;
    y = 2 * q * (difference + q * first_last_sum_) / length2;
  }
  // 1 + the cosine from the pivot to the arc. The point's own cosine is 1 - xi (1 - cosine of the arc).
  const double above = std::clamp(half_square(pivot_ + first_ * x + last_ * y), 1e-60, 2.0);
  const double cosine = 1 - 2 * xi + xi * above;
  // A ratio of sines from which 1 - cosine was cancelled.
  const double ratio = std::sqrt(xi * (2 - 2 * xi + xi * above) / above);
  Vec3d weights(std::max(0.0, cosine + ratio * (1 - above)), ratio * x, ratio * y);
  weights *= inverse_lengths_;
  return weights / (weights.x + weights.y + weights.z);
}

Vec2d SphericalTriangle::sample(const Vec2f& xi) const {
  const Vec3d at = weights(xi.x * solid_angle_, xi.y);
  return {at.y, at.z};
}

SphericalParallelogram::SphericalParallelogram(const Vec3d& corner, const Vec3d& edge1, const Vec3d& edge2)
    : SphericalParallelogram(corner, edge1, edge2, -edge1.cross(edge2).dot(corner)) {}

SphericalParallelogram::SphericalParallelogram(const Vec3d& corner, const Vec3d& edge1, const Vec3d& edge2,
                                               double volume)
    : first_(corner, corner + edge1, corner + edge1 + edge2, volume),
      second_(corner, corner + edge1 + edge2, corner + edge2, volume) {}

Vec2d SphericalParallelogram::sample(const Vec2f& xi) const {
  const float part = xi.x * solid_angle();
  if (part < first_.solid_angle()) {
    const Vec3d at = first_.weights(part, xi.y);
    return {at.y + at.z, at.z};
  }
  const Vec3d at = second_.weights(std::min(part - first_.solid_angle(), second_.solid_angle()), xi.y);
  return {at.y, at.y + at.z};
}

}  // namespace transport
