// Random numbers, weights and paths at extremes, and cameras of distant scenes.
#include <numbers>

#include "renderer/transport/integrators/power_heuristic.h"
#include "renderer/transport/lights/lights.h"
#include "tests/stability/hard_case.h"
#include "tests/transport/scene_helpers.h"
#include "tests/transport/solid_angles.h"

namespace test {
namespace {

using grf::Vec3d;
using transport::Vec3f;

Errors numbers_below_one() {
  constexpr std::uint32_t Points = 1U << 24U;
  std::uint64_t ours = 0;
  std::uint64_t naive = 0;
  for (std::uint32_t i = 0; i < Points; ++i) {
    const auto point = transport::sobol_point(i, 1);
    for (const float number : {point.x, point.y, point.z, point.w}) ours += number >= 1 ? 1U : 0U;
    for (std::uint32_t k = 0; k < 4; ++k) {
      const float number = static_cast<float>(transport::hash(i, k)) * 0x1p-32F;
      naive += number >= 1 ? 1U : 0U;
    }
  }
  return {static_cast<double>(ours) / (4.0 * Points), static_cast<double>(naive) / (4.0 * Points)};
}

/// Tests weights above 1e-6.
Errors weights_of_large_pdfs() {
  Random random;
  Errors errors;
  for (int i = 0; i < 10000; ++i) {
    const float a = random.log_uniform(1e-30F, 1e30F);
    const float b = a * random.log_uniform(1e-3F, 1e3F);
    const double exact = double(a) * a / (double(a) * a + double(b) * b);
    errors.include({relative_error(transport::power_heuristic(a, b), exact),
                    relative_error(a * a / (a * a + b * b), exact)});
  }
  return errors;
}

/// Returns the relative error of the radiance that all pixels see.
double worst_of_seeds(const transport::CompiledScene& scene, RenderSetup setup, double exact) {
  double worst = 0;
  for (setup.seed = 0; setup.seed < 4; ++setup.seed) {
    worst = std::max(worst, relative_error(mean_radiance(render(scene, setup)).mean, exact));
  }
  return worst;
}

/// Tests a light reflected in a coated floor: diffuse plus specular. Naive code weights a specular direction
/// as one with pdf 1.
Errors lamp_in_a_mirror() {
  const std::string brdf = "coupled Rm=1 R0=0.05";
  const Vec3f u = reflectance::from_angles(0.6F, 0.8F, 0);
  const Vec3f middle = reflectance::mirrored(u) * 4;
  const reflectance::Frame frame(-middle.normalized());
  const Vec3f edge1 = frame.x * 0.1F;
  const Vec3f edge2 = frame.y * 0.1F;
  const Vec3f corner = middle - (edge1 + edge2) / 2;
  const auto text = [](const Vec3f& v) { return fmt::format("({},{},{}) ", v.x, v.y, v.z); };
  const auto scene = scene_of("light begin rgb (1,1,1) " + text(corner) + text(edge1) + text(edge2) + "end " +
                              quad("brdf " + brdf, "(-9,-9,0) (9,-9,0) (9,9,0) (-9,9,0)"));
  RenderSetup setup;
  setup.eye = u * 4;
  setup.field_of_view = 0.001F;
  setup.width = setup.height = 4;
  setup.samples = 512;
  setup.depth = 1;
  const auto point = scene.intersect({setup.eye, -u}).value();
  const auto& reflector = *scene.reflector(*point.surface);
  const reflectance::Frame floor(point.shading_normal);
  const Vec3f local = floor.to_local(u);
  const Vec3l a(corner);
  const double received =
      lambert_irradiance({a, a + Vec3l(edge1), a + Vec3l(edge1) + Vec3l(edge2), a + Vec3l(edge2)}, {0, 0, 1});
  const double diffuse = received * double(reflector.evaluate(local, reflectance::mirrored(local)).x);
  const double mirror = double(reflectance::specular_weight(reflector.brdf(), local).x);
  const float pdf = scene.lights().pdf(Vec3f(0), Vec3f(0, 0, 1), 0, middle.normalized());
  const double naive = diffuse + mirror * double(transport::power_heuristic(1, pdf));
  return {worst_of_seeds(scene, setup, diffuse + mirror), relative_error(naive, diffuse + mirror)};
}

/// Tests a floor under a lamp of radiance 1e-10, beside one of 1e10 in a closed box. Naive code samples
/// lights in proportion to their power, and directions by nothing else: it never sees the dim lamp.
Errors dim_lamp_beside_a_bright_one() {
  const auto lamp = [](const char* radiance, float x) {
    return fmt::format("light begin rgb ({0},{0},{0}) ({1},-0.5,1) (0,1,0) (1,0,0) end ", radiance, x - 0.5F);
  };
  const auto scene = scene_of(lamp("1e-10", 0) + lamp("1e10", 5) +
                              placed(box("brdf diffuse kd=0.5"), Vec3f(0.8F), Vec3f(0), Vec3f(5, 0, 1)) +
                              quad("brdf diffuse kd=0.5", "(-1,-1,0) (1,-1,0) (1,1,0) (-1,1,0)"));
  RenderSetup setup;
  setup.eye = Vec3f(0, -2, 1);
  setup.field_of_view = 0.001F;
  setup.width = setup.height = 4;
  setup.samples = 1024;
  setup.depth = 1;
  const double received =
      lambert_irradiance({{-0.5L, -0.5L, 1}, {-0.5L, 0.5L, 1}, {0.5L, 0.5L, 1}, {0.5L, -0.5L, 1}}, {0, 0, 1});
  const double exact = 1e-10 * received * 0.5 / std::numbers::pi;
  Random random;
  double naive = 0;
  for (int i = 0; i < setup.samples; ++i) {
    const float dim = 1e-10F / (1e-10F + 1e10F);  // of the whole power: both have the same area
    if (random.uniform(0, 1) < dim) naive += exact / double(dim) / setup.samples;
  }
  return {worst_of_seeds(scene, setup, exact), relative_error(naive, exact)};
}

/// Tests a closed white box that emits: each vertex of a path of depth 1000 adds 1.
Errors depth_of_thousand() {
  constexpr int Depth = 1000;
  RenderSetup setup;
  setup.eye = Vec3f(0.1F, 0.2F, 0.3F);
  setup.target = Vec3f(1, 0.3F, 0.4F);
  setup.width = setup.height = 8;
  setup.samples = 1;
  setup.depth = Depth;
  const auto scene = scene_of(box("brdf diffuse kd=1 light rgb (1,1,1)"));
  const int paths = setup.width * setup.height * setup.samples;
  Random random;
  double naive = 0;
  for (int i = 0; i < paths; ++i) {
    float throughput = 1;
    for (int events = 0; events <= Depth; ++events) {
      naive += static_cast<double>(throughput) / paths;
      if (events < 3) continue;
      if (random.uniform(0, 1) < 0.5F) break;
      throughput /= 0.5F;
    }
  }
  return {worst_of_seeds(scene, setup, Depth + 1), relative_error(naive, Depth + 1)};
}

constexpr int Pixels = 500;

/// Returns where a pinhole camera sees the plane through the target that faces along z.
template <class Real>
Vec3d seen_place(const transport::View& view, Real x, Real y) {
  using Vec = Imath::Vec3<Real>;
  const Vec eye(view.eye);
  const Vec target(view.target);
  const Vec forward = (target - eye).normalized();
  const Vec right = forward.cross(Vec(view.up)).normalized();
  const Vec up = right.cross(forward);
  const Real half = std::tan(Real(view.field_of_view) * std::numbers::pi_v<Real> / 360);
  const Vec direction = forward + right * (half * (2 * x / Pixels - 1)) + up * (half * (1 - 2 * y / Pixels));
  return Vec3d(eye + direction * ((target.z - eye.z) / direction.z));
}

Errors far_camera() {
  Random random;
  Errors errors;
  for (int i = 0; i < 1000; ++i) {
    const Vec3d offset(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    transport::View view;
    view.target = Vec3d(1e6, -1e6, 1e6) + offset;
    view.eye = view.target + Vec3d(0.5, 1, 4);
    const Vec3d origin(1e6, -1e6, 1e6);
    const transport::Camera camera(transport::relative_to(origin, view), Pixels, Pixels);
    const float x = random.uniform(0, Pixels);
    const float y = random.uniform(0, Pixels);
    const transport::Ray ray = camera.ray(x, y);
    const float distance = (static_cast<float>(offset.z) - ray.origin.z) / ray.direction.z;
    const Vec3d ours = Vec3d(ray.origin + ray.direction * distance) + origin;
    const Vec3d exact = seen_place<double>(view, x, y);
    const double pixel = 2 * 4 * std::tan(double(view.field_of_view) * std::numbers::pi / 360) / Pixels;
    errors.include(
        {(ours - exact).length() / pixel, (seen_place<float>(view, x, y) - exact).length() / pixel});
  }
  return errors;
}

/// Tests views (nearly) straight up and down: the deviation of the image's centre and steps from a frame.
Errors camera_along_up() {
  Random random;
  Errors errors;
  for (int i = 0; i < 1000; ++i) {
    transport::View view;
    const double off = i % 2 == 0 ? 0 : double(random.log_uniform(1e-30F, 1e-12F));
    view.target = Vec3d(off, i % 4 < 2 ? 4 : -4, 0);
    const transport::Camera camera(view, Pixels, Pixels);
    const Vec3f middle = camera.ray(Pixels / 2.0F, Pixels / 2.0F).direction;
    const Vec3f right = (camera.ray(Pixels, Pixels / 2.0F).direction - middle).normalized();
    const double exact = 1;
    const auto error = [&](const Vec3f& across) {
      return relative_error(double(middle.cross(across).length()), exact);
    };
    const Vec3f crossed = middle.cross(view.up);
    const Vec3f naive = crossed / std::sqrt(crossed.dot(crossed));
    errors.include({std::abs(double(middle.y)) == 1 ? error((right - middle * right.dot(middle)).normalized())
                                                    : INFINITY,
                    error(naive)});
  }
  return errors;
}

}  // namespace

std::vector<HardCase> sampling_cases() {
  constexpr std::string_view Radiance = "relative error of the radiance";
  return {
      {"2^26 random numbers in [0,1)", "32 bits times 2^-32, rounded to float", "24 bits times 2^-24", 3e-8,
       0, 0, numbers_below_one, "fraction of numbers that are 1"},
      {"Power-heuristic weights of pdfs from 1e-30 to 1e30", "a^2/(a^2 + b^2)", "1/(1 + (b/a)^2)", INFINITY,
       1e-5, 2e-7, weights_of_large_pdfs},
      {"Light of 6e-4 sr reflected in a coated diffuse floor", "specular directions have pdf 1",
       "specular directions have MIS weight 1", 1, 0.02, 2e-3, lamp_in_a_mirror, Radiance, Kind::Noisy},
      {"A lamp of 1e-10 beside one of 1e10 in a closed box", "lights in proportion to their power",
       "multiple importance sampling with the BRDF", 1, 0.02, 1e-3, dim_lamp_beside_a_bright_one, Radiance,
       Kind::Noisy},
      {"Closed white box that emits, depth 1000", "Russian roulette of 1/2 from the fourth bounce on",
       "roulette only below a throughput of 1/3", 1, 0.02, 8e-4, depth_of_thousand, Radiance, Kind::Noisy},
      {"Camera 1e6 from the origin", "eye and target in float", "in double, relative to the scene's centre",
       12, 0.01, 1e-4, far_camera, "error in pixels"},
      {"View along the up direction", "right is the cross product, normalised",
       "another axis where that cancels", INFINITY, 1e-5, 0, camera_along_up,
       "distance of the axes from unit vectors"},
  };
}

}  // namespace test
