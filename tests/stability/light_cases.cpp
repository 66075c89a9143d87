// Lights that are seen edge-on, are tiny or huge, or touch what they light: single lights without occlusion.
#include <numbers>

#include "renderer/transport/lights/lights.h"
#include "renderer/transport/lights/spherical_rectangle.h"
#include "renderer/transport/sobol.h"
#include "tests/stability/hard_case.h"
#include "tests/transport/solid_angles.h"

namespace test {
namespace {

using grf::Vec2d;
using grf::Vec2f;
using grf::Vec3d;
using transport::Emitter;
using transport::Lights;
using transport::Vec3f;

/// Returns the spherical excess of a triangle, by arc cosines (Girard).
template <class Real>
Real girard(Imath::Vec3<Real> a, Imath::Vec3<Real> b, Imath::Vec3<Real> c) {
  const auto ab = a.cross(b).normalized();
  const auto bc = b.cross(c).normalized();
  const auto ca = c.cross(a).normalized();
  return std::acos(-ab.dot(bc)) + std::acos(-bc.dot(ca)) + std::acos(-ca.dot(ab)) - std::numbers::pi_v<Real>;
}

/// Returns the solid angle of an emitter's triangle from a point.
template <class Real>
double naive_solid_angle(const Emitter& emitter, const Vec3f& from) {
  using Vec = Imath::Vec3<Real>;
  const Vec a = Vec(emitter.corner) - Vec(from);
  return static_cast<double>(girard(a, a + Vec(emitter.edge1), a + Vec(emitter.edge2)));
}

Errors errors_of_solid_angle(const Emitter& emitter, const Vec3f& from) {
  const Vec3l corner = Vec3l(emitter.corner) - Vec3l(from);
  const double exact = solid_angle_of_triangle(corner, Vec3l(emitter.edge1), Vec3l(emitter.edge2));
  const Vec3f to_middle = emitter.corner + (emitter.edge1 + emitter.edge2) / 3 - from;
  const Vec3f direction = to_middle.normalized();
  const double pdf = Lights({emitter}).pdf(from, direction, 0, direction);
  return {relative_error(1 / pdf, exact), relative_error(naive_solid_angle<float>(emitter, from), exact),
          relative_error(naive_solid_angle<double>(emitter, from), exact)};
}

Vec3f any_direction(Random& random) { return random.direction(random.uniform(-1, 1)); }

Emitter triangle(const Vec3f& corner, const Vec3f& edge1, const Vec3f& edge2) {
  return {corner, edge1, edge2, true, reflectance::Rgb(1)};
}

/// Tests points beside a triangle barely above its plane.
Errors edge_on() {
  Random random;
  Errors errors;
  for (int i = 0; i < 10000; ++i) {
    const Vec3f normal = any_direction(random);
    const reflectance::Frame frame(normal, any_direction(random));
    const Emitter emitter = triangle(any_direction(random), frame.x, frame.y);
    const float along = random.uniform(1.1F, 2);
    const Vec3f from =
        emitter.corner + frame.x * along + frame.y * 0.3F + normal * random.log_uniform(1e-6F, 1e-3F);
    const Vec3d corner = Vec3d(emitter.corner) - Vec3d(from);
    const double height = -Vec3d(emitter.edge1).cross(Vec3d(emitter.edge2)).dot(corner);
    if (height < 1e-6) continue;  // rounding moved the point to the plane
    errors.include(errors_of_solid_angle(emitter, from));
  }
  return errors;
}

Errors tiny() {
  Random random;
  Errors errors;
  for (int i = 0; i < 10000; ++i) {
    const Vec3f normal = any_direction(random);
    const reflectance::Frame frame(normal, any_direction(random));
    const Emitter emitter = triangle(any_direction(random), frame.x * 1e-6F, frame.y * 1e-6F);
    const Vec3f tilted = (normal + frame.x * random.uniform(-1, 1)).normalized();
    errors.include(errors_of_solid_angle(emitter, emitter.corner + tilted * random.log_uniform(0.01F, 1000)));
  }
  return errors;
}

/// Samples a rectangle at z = -1 as the paper prints it (Urena, Fajardo and King 2013, algorithms 1 and 2).
template <class Real>
Vec2d urena_place(Real x0, Real y0, Real width, Real height, const Vec2f& xi) {
  using Vec = Imath::Vec3<Real>;
  const Real x1 = x0 + width;
  const Real y1 = y0 + height;
  const Vec v00(x0, y0, -1);
  const Vec v01(x0, y1, -1);
  const Vec v10(x1, y0, -1);
  const Vec v11(x1, y1, -1);
  const Vec n0 = v00.cross(v10).normalized();
  const Vec n1 = v10.cross(v11).normalized();
  const Vec n2 = v11.cross(v01).normalized();
  const Vec n3 = v01.cross(v00).normalized();
  const Real k = 2 * std::numbers::pi_v<Real> - std::acos(-n2.dot(n3)) - std::acos(-n3.dot(n0));
  const Real solid_angle = std::acos(-n0.dot(n1)) + std::acos(-n1.dot(n2)) - k;
  const Real au = Real(xi.x) * solid_angle + k;
  const Real fu = (std::cos(au) * n0.z - n2.z) / std::sin(au);
  const Real cu =
      std::clamp((fu > 0 ? Real(1) : Real(-1)) / std::sqrt(fu * fu + n0.z * n0.z), Real(-1), Real(1));
  const Real x = std::clamp(cu / std::sqrt(1 - cu * cu), x0, x1);
  const Real d = std::sqrt(x * x + 1);
  const Real h0 = y0 / std::sqrt(d * d + y0 * y0);
  const Real h1 = y1 / std::sqrt(d * d + y1 * y1);
  const Real h = h0 + Real(xi.y) * (h1 - h0);
  const Real y = h * h < Real(1 - 1e-6) ? h * d / std::sqrt(1 - h * h) : y1;
  return {static_cast<double>((x - x0) / width), static_cast<double>((y - y0) / height)};
}

Errors places_on_rectangle() {
  Random random;
  Errors errors;
  for (int i = 0; i < 10000; ++i) {
    const float x0 = random.uniform(-1, 1);
    const float y0 = random.uniform(-1, 1);
    const float side = random.log_uniform(1e-3F, 1e-2F);
    const Vec2f xi(random.uniform(0, 1), random.uniform(0, 1));
    const Vec2d exact = urena_place<long double>(x0, y0, side, side, xi);
    const auto distance = [&](const Vec2d& place) {
      return std::isfinite(place.x) ? (place - exact).length() : INFINITY;
    };
    const transport::SphericalRectangle ours({x0, y0, -1}, {side, 0, 0}, {0, side, 0});
    errors.include({distance(ours.sample(xi)), distance(urena_place<float>(x0, y0, side, side, xi)),
                    distance(urena_place<double>(x0, y0, side, side, xi))});
  }
  return errors;
}

constexpr int SamplesOfLight = 1024;

/// Estimates the irradiance from a rectangle of radiance 1 by our light sampling.
double sampled_irradiance(const Lights& lights, const Vec3f& from, const Vec3f& normal, std::uint32_t seed) {
  double sum = 0;
  for (int i = 0; i < SamplesOfLight; ++i) {
    const auto xi = transport::sobol_point(static_cast<std::uint32_t>(i), seed);
    const auto light = lights.sample(from, normal, xi.z, xi.xy());
    if (light) sum += std::max(0.0F, light->direction.dot(normal)) / light->pdf;
  }
  return sum / SamplesOfLight;
}

/// Estimates the same by uniform area sampling.
double naive_irradiance(const Emitter& emitter, const Vec3f& from, const Vec3f& normal, std::uint32_t seed) {
  const Vec3f area = emitter.doubled_area_normal();
  const float size = area.length();
  double sum = 0;
  for (int i = 0; i < SamplesOfLight; ++i) {
    const auto xi = transport::sobol_point(static_cast<std::uint32_t>(i), seed);
    const Vec3f to_light = emitter.corner + emitter.edge1 * xi.x + emitter.edge2 * xi.y - from;
    const Vec3f direction = to_light.normalized();
    const float facing = -direction.dot(area) / size;
    if (facing > 0) {
      sum += std::max(0.0F, direction.dot(normal)) * facing * size / to_light.length2();
    }
  }
  return sum / SamplesOfLight;
}

Errors errors_of_irradiance(const Emitter& emitter, const Vec3f& from, const Vec3f& normal,
                            std::uint32_t seed) {
  const Vec3l a = Vec3l(emitter.corner) - Vec3l(from);
  const Vec3l b = a + Vec3l(emitter.edge1);
  const Vec3l c = a + Vec3l(emitter.edge2);
  const double exact = lambert_irradiance({a, b, b + Vec3l(emitter.edge2), c}, Vec3l(normal));
  return {relative_error(sampled_irradiance(Lights({emitter}), from, normal, seed), exact),
          relative_error(naive_irradiance(emitter, from, normal, seed), exact)};
}

/// Tests a floor 1e-6 to 1e-3 in front of an emissive wall that stands on it.
Errors touching() {
  Random random;
  Errors errors;
  const Emitter wall{Vec3f(0, -0.5F, 0), Vec3f(0, 1, 0), Vec3f(0, 0, 1), false, reflectance::Rgb(1)};
  for (int i = 0; i < 100; ++i) {
    const Vec3f from(random.log_uniform(1e-6F, 1e-3F), random.uniform(-0.4F, 0.4F), 0);
    errors.include(errors_of_irradiance(wall, from, Vec3f(0, 0, 1), static_cast<std::uint32_t>(i)));
  }
  return errors;
}

Errors huge() {
  Random random;
  Errors errors;
  const Emitter sky{Vec3f(-5e5F, -5e5F, 1), Vec3f(0, 1e6F, 0), Vec3f(1e6F, 0, 0), false, reflectance::Rgb(1)};
  for (int i = 0; i < 100; ++i) {
    const Vec3f from(random.uniform(-4e5F, 4e5F), random.uniform(-4e5F, 4e5F), 0);
    errors.include(errors_of_irradiance(sky, from, Vec3f(0, 0, 1), static_cast<std::uint32_t>(i)));
  }
  return errors;
}

/// Tests a strip of 1000 x 1e-3 along the floor.
Errors strip() {
  Random random;
  Errors errors;
  const Emitter lamp{Vec3f(-500, -5e-4F, 1), Vec3f(0, 1e-3F, 0), Vec3f(1000, 0, 0), false,
                     reflectance::Rgb(1)};
  for (int i = 0; i < 100; ++i) {
    const Vec3f from(random.uniform(-400, 400), random.uniform(-1, 1), 0);
    errors.include(errors_of_irradiance(lamp, from, Vec3f(0, 0, 1), static_cast<std::uint32_t>(i)));
  }
  return errors;
}

}  // namespace

std::vector<HardCase> light_cases() {
  constexpr std::string_view SolidAngle = "relative error of the solid angle";
  constexpr std::string_view Irradiance = "relative error of the irradiance of 1024 samples";
  return {
      {"Light seen edge-on, from 1e-6 above its plane", "spherical excess by three arc cosines (Girard)",
       "the arc tangent of a volume over a sum, products in double", INFINITY, 1e-5, 1e-7, edge_on,
       SolidAngle},
      {"Light of 1e-6, from 0.01 to 1000 away", "spherical excess by three arc cosines (Girard)",
       "by area where that is as accurate", INFINITY, 1e-4, 1e-5, tiny, SolidAngle},
      {"Rectangular light that fills 1e-7 to 1e-4 sr",
       "the paper's sum of four arc cosines, and its sine of one", "sines and cosines without angles", 1,
       1e-5, 1e-7, places_on_rectangle,
       "distance of points from their exact positions, in the light's sides"},
      {"Floor 1e-6 to 1e-3 in front of an emissive wall", "uniform area sampling, cos cos/d^2",
       "uniform solid-angle sampling", 13, 0.02, 2e-4, touching, Irradiance, Kind::Noisy},
      {"Light of 1e6 x 1e6, 1 above the floor", "uniform area sampling, cos cos/d^2",
       "uniform solid-angle sampling", 1, 0.02, 5e-4, huge, Irradiance, Kind::Noisy},
      {"Light of 1000 x 0.001, 1 above the floor", "uniform area sampling, cos cos/d^2",
       "uniform solid-angle sampling", 0.5, 0.02, 5e-5, strip, Irradiance, Kind::Noisy},
  };
}

}  // namespace test
