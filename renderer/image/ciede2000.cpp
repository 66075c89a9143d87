#include "renderer/image/ciede2000.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace image {
namespace {

constexpr double Pi = std::numbers::pi;

double radians(double degrees) { return degrees * Pi / 180; }

double seventh_power(double x) {
  const double cube = x * x * x;
  return cube * cube * x;
}

/// The part of a chroma that the formula takes for grey axes: the root of C^7 / (C^7 + 25^7).
double grey_part(double chroma) {
  const double power = seventh_power(chroma);
  return std::sqrt(power / (power + seventh_power(25)));
}

/// A colour as the formula sees it: a' = (1 + G) a, in polar coordinates.
struct Polar {
  double lightness = 0;
  double chroma = 0;
  double hue = 0;  ///< from 0 to 2 pi; 0 for grey
};

Polar polar_of(const Lab& colour, double grey) {
  const double a = (1 + grey) * colour.a;
  const double chroma = std::hypot(a, colour.b);
  double hue = a == 0 && colour.b == 0 ? 0 : std::atan2(colour.b, a);
  if (hue < 0) hue += 2 * Pi;
  return {colour.lightness, chroma, hue};
}

/// The hue halfway along the shorter arc; of a grey and a colour, their sum, which is the colour's.
double mean_hue(const Polar& first, const Polar& second) {
  const double sum = first.hue + second.hue;
  if (first.chroma * second.chroma == 0) return sum;
  if (std::abs(first.hue - second.hue) <= Pi) return sum / 2;
  return sum < 2 * Pi ? sum / 2 + Pi : sum / 2 - Pi;
}

double hue_difference(const Polar& first, const Polar& second) {
  if (first.chroma * second.chroma == 0) return 0;
  const double difference = second.hue - first.hue;
  if (difference > Pi) return difference - 2 * Pi;
  return difference < -Pi ? difference + 2 * Pi : difference;
}

double lab_curve(double t) {
  constexpr double Delta = 6.0 / 29;
  return t > Delta * Delta * Delta ? std::cbrt(t) : t / (3 * Delta * Delta) + 4.0 / 29;
}

}  // namespace

Lab lab_of(const grf::Vec3d& xyz, const grf::Vec3d& white) {
  const double x = lab_curve(xyz.x / white.x);
  const double y = lab_curve(xyz.y / white.y);
  const double z = lab_curve(xyz.z / white.z);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

// Equations 2 to 22 of the paper.
double ciede2000(const Lab& first, const Lab& second) {
  const double raw_chroma = (std::hypot(first.a, first.b) + std::hypot(second.a, second.b)) / 2;
  const double grey = 0.5 * (1 - grey_part(raw_chroma));
  const Polar one = polar_of(first, grey);
  const Polar other = polar_of(second, grey);

  const double lightness_difference = other.lightness - one.lightness;
  const double chroma_difference = other.chroma - one.chroma;
  const double hue_arc = 2 * std::sqrt(one.chroma * other.chroma) * std::sin(hue_difference(one, other) / 2);

  const double lightness = (one.lightness + other.lightness) / 2;
  const double chroma = (one.chroma + other.chroma) / 2;
  const double hue = mean_hue(one, other);
  const double t = 1 - 0.17 * std::cos(hue - radians(30)) + 0.24 * std::cos(2 * hue) +
                   0.32 * std::cos(3 * hue + radians(6)) - 0.20 * std::cos(4 * hue - radians(63));
  const double from_blue = (hue - radians(275)) / radians(25);
  const double rotation = radians(30) * std::exp(-from_blue * from_blue);
  const double from_middle = (lightness - 50) * (lightness - 50);
  const double lightness_weight = 1 + 0.015 * from_middle / std::sqrt(20 + from_middle);
  const double l = lightness_difference / lightness_weight;
  const double c = chroma_difference / (1 + 0.045 * chroma);
  const double h = hue_arc / (1 + 0.015 * chroma * t);
  const double crossed = -std::sin(2 * rotation) * 2 * grey_part(chroma);
  return std::sqrt(std::max(0.0, l * l + c * c + h * h + crossed * c * h));
}

}  // namespace image
