#pragma once

#include <string>

#include "tests/reflectance/brdf_cases.h"
#include "tests/statistics/quadrature.h"

namespace test {

/// Computes the directional albedo by quadrature, without the delta part.
inline double albedo(const Brdf& brdf, const Vec3f& u, double tolerance = 1e-8) {
  const auto integrand = [&](const Vec3f& v) { return evaluate(brdf, u, v).x * double(v.z); };
  return statistics::Quadrature(integrand, reflectance::mirrored(u), tolerance).over_hemisphere();
}
inline double albedo(const std::string& brdf, double theta_degrees, double phi_degrees = 25,
                     double tolerance = 1e-8) {
  return albedo(brdf_of(brdf), direction(theta_degrees, phi_degrees), tolerance);
}

}  // namespace test
