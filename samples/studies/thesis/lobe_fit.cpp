#include "samples/studies/thesis/lobe_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "renderer/reflectance/schemes/view_square.h"

namespace study {
namespace {

using reflectance::Brdf;
using reflectance::Vec3f;

constexpr int Resolution = 120;  // cells along an edge of the square that the hemisphere is mapped to
constexpr double SolidAngle = 2 * std::numbers::pi / (Resolution * Resolution);

Vec3f direction(int i) {
  const auto coordinate = [](int index) { return (2 * static_cast<float>(index) + 1) / Resolution - 1; };
  return reflectance::from_square(coordinate(i % Resolution), coordinate(i / Resolution));
}

double distance_of_view(const Brdf& brdf, const reflectance::Scheme& scheme, const Vec3f& u) {
  double albedo = 0;
  for (int i = 0; i < Resolution * Resolution; ++i) {
    const Vec3f v = direction(i);
    albedo += reflectance::mean(evaluate(brdf, u, v)) * v.z * SolidAngle;
  }
  double distance = 0;
  for (int i = 0; i < Resolution * Resolution; ++i) {
    const Vec3f v = direction(i);
    const double ideal_pdf = reflectance::mean(evaluate(brdf, u, v)) * v.z / albedo;
    distance += std::abs(pdf(scheme, brdf, u, v) - ideal_pdf) * SolidAngle / 2;
  }
  return distance;
}

}  // namespace

double total_variation_distance(const Brdf& brdf, double exponent) {
  reflectance::HemisphereScheme lobe;
  lobe.exponent = static_cast<float>(exponent);
  lobe.build(brdf);
  const reflectance::Scheme scheme = lobe;
  double sum = 0;
  for (const double degrees : {20.0, 45.0, 70.0}) {
    const double angle = degrees * std::numbers::pi / 180;
    sum += distance_of_view(
        brdf, scheme, Vec3f(static_cast<float>(std::sin(angle)), 0, static_cast<float>(std::cos(angle))));
  }
  return sum / 3;
}

double best_lobe_exponent(const Brdf& brdf) {
  double best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (const double exponent :
       {0.5, 1.0, 2.0, 3.0, 5.0, 7.0, 10.0, 14.0, 20.0, 30.0, 50.0, 70.0, 100.0, 200.0, 500.0, 1000.0}) {
    const double distance = total_variation_distance(brdf, exponent);
    if (distance < least) best = exponent;
    least = std::min(least, distance);
  }
  return best;
}

}  // namespace study
