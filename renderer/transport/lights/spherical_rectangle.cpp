#include "renderer/transport/lights/spherical_rectangle.h"

#include <algorithm>
#include <cmath>

namespace transport {
namespace {

struct RectangleAngle {
  double cosine, sine;
};

/// 1 - cosine, without cancellation.
double one_minus_cos(const RectangleAngle& a) {
  return a.cosine > 0 ? a.sine * a.sine / (1 + a.cosine) : 1 - a.cosine;
}

/// cos a - cos b, without cancellation even if both are near 1 or -1.
double difference(const RectangleAngle& a, const RectangleAngle& b) {
  if (a.cosine > 0) return one_minus_cos(b) - one_minus_cos(a);
  return one_minus_cos({-a.cosine, a.sine}) - one_minus_cos({-b.cosine, b.sine});
}

}  // namespace

SphericalRectangle::SphericalRectangle(const Vec3d& corner, const Vec3d& edge1, const Vec3d& edge2)
    : corner_(corner),
      edge1_(edge1),
      edge2_(edge2),
      width_(std::sqrt(edge1.dot(edge1))),
      height_(std::sqrt(edge2.dot(edge2))),
      x0_(corner.dot(edge1) / width_),
      y0_(corner.dot(edge2) / height_),
      z_(-edge1.cross(edge2).dot(corner) / (width_ * height_)) {
  if (!(z_ > 0)) return;
  const double x1 = x0_ + width_;
  const double y1 = y0_ + height_;
  const double z2 = z_ * z_;
  r00_ = std::sqrt(x0_ * x0_ + y0_ * y0_ + z2);
  r01_ = std::sqrt(x0_ * x0_ + y1 * y1 + z2);
  const double r10 = std::sqrt(x1 * x1 + y0_ * y0_ + z2);
  const double r11 = std::sqrt(x1 * x1 + y1 * y1 + z2);
  if (!(std::min({r00_, r01_, r10, r11}) > 0)) return;
  // The tangents of half the solid angle of each triangle, combined as complex numbers.
  const double volume = width_ * height_ * z_;
  const double across = x0_ * x1 + y0_ * y1 + z2;
  const double lower =
      r00_ * r10 * r11 + (x0_ * x1 + y0_ * y0_ + z2) * r11 + (x1 * x1 + y0_ * y1 + z2) * r00_ + across * r10;
  const double upper = r00_ * r11 * r01_ + across * r01_ + (x0_ * x1 + y1 * y1 + z2) * r00_ +
                       (x0_ * x0_ + y0_ * y1 + z2) * r11;
  solid_angle_ = 2 * angle_of(volume * std::max(lower + upper, 0.0), lower * upper - volume * volume);
}

/// The x up to which the solid angle is `part`.
double SphericalRectangle::x_for(float part) const {
  const double y1 = y0_ + height_;
  const double z2 = z_ * z_;
  const double product = std::sqrt((y0_ * y0_ + z2) * (y1 * y1 + z2));
  // The difference and the sum of the elevation angles of y0 and y1.
  const RectangleAngle span{(z2 + y0_ * y1) / product, z_ * height_ / product};
  const RectangleAngle sum{(z2 - y0_ * y1) / product, z_ * (y0_ + y1) / product};
  // G at x0. In its sine, y1 r00 - y0 r01 is written without cancellation.
  const double square = x0_ * x0_ + z2;
  const double weight =
      y0_ * y1 > 0 ? square * height_ * (y0_ + y1) / (y1 * r00_ + y0_ * r01_) : y1 * r00_ - y0_ * r01_;
  const double sine_start = x0_ * z_ * weight / (product * square);
  const double cosine_start = (z2 * r00_ * r01_ + x0_ * x0_ * y0_ * y1) / (product * square);
  const double sine_half = std::sin(part / 2);
  const double sine_part = 2 * sine_half * std::cos(part / 2);
  const double cosine_part = 1 - 2 * sine_half * sine_half;
  const RectangleAngle g{cosine_start * cosine_part - sine_start * sine_part,
                         sine_start * cosine_part + cosine_start * sine_part};
  const double rest = difference(g, span) * difference(g, {-sum.cosine, sum.sine});
  const double x = z_ * g.sine / std::sqrt(std::max(rest, 1e-80));
  return std::clamp(x, x0_, x0_ + width_);
}

/// Samples across the strip at x: uniformly in the sine of the elevation; 1 - sine and 1 + sine are kept for
/// accuracy.
double SphericalRectangle::y_for(double x, double xi) const {
  const double distance2 = x * x + z_ * z_;
  const auto between = [xi](double a, double b) { return (1 - xi) * a + xi * b; };
  const auto one_minus_sine = [distance2](double y) {
    const double length = std::sqrt(distance2 + y * y);
    return y > 0 ? distance2 / (length * (length + y)) : (length - y) / length;
  };
  const double y1 = y0_ + height_;
  const double below = between(one_minus_sine(y0_), one_minus_sine(y1));
  const double above = between(one_minus_sine(-y0_), one_minus_sine(-y1));
  const double y = std::sqrt(distance2) * (above - below) / (2 * std::sqrt(below * above));
  return std::clamp(y, y0_, y1);
}

Vec2d SphericalRectangle::sample(const Vec2f& xi) const {
  if (solid_angle_ < Small) return SphericalParallelogram(corner_, edge1_, edge2_).sample(xi);
  const double x = x_for(xi.x * solid_angle_);
  const double y = y_for(x, xi.y);
  return {std::clamp((x - x0_) / width_, 0.0, 1.0), std::clamp((y - y0_) / height_, 0.0, 1.0)};
}

}  // namespace transport
