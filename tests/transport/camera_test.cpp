// The thin lens of the camera, and the depth of field that it makes, against closed forms.
#include "renderer/transport/camera.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "renderer/transport/sobol.h"
#include "tests/transport/scene_helpers.h"

namespace {

using grf::Vec3d;
using transport::Camera;
using transport::Ray;
using transport::Vec3f;
using transport::View;

View oblique_view() {
  View view;
  view.eye = Vec3d(1, 2, 3);
  view.target = Vec3d(4, 1, -2);
  view.lens_radius = 0.3F;
  view.focus_distance = 5;
  return view;
}

TEST(ThinLens, FocusesRaysOfOneImagePointInThePlaneOfFocus) {
  const View view = oblique_view();
  const Vec3d forward = (view.target - view.eye).normalized();
  const Camera camera(view, 40, 30);
  for (const auto& [x, y] : {std::pair(0.0F, 0.0F), {20.0F, 15.0F}, {33.5F, 4.25F}}) {
    const Ray centre = camera.ray(x, y);
    const Vec3d direction(centre.direction);
    const Vec3d focus = view.eye + direction * (5 / direction.dot(forward));
    for (std::uint32_t i = 0; i < 64; ++i) {
      const Ray ray = camera.ray(x, y, transport::sobol_point(i, 1).xy());
      const Vec3d from(ray.origin);
      EXPECT_NEAR((from - view.eye).dot(forward), 0, 1e-6);
      const Vec3d way = focus - from;
      EXPECT_NEAR(way.cross(Vec3d(ray.direction)).length(), 0, 1e-5);
      EXPECT_NEAR(ray.direction.length(), 1, 1e-6);
    }
  }
}

// The moments of a uniform disc: the mean of r^2 is R^2 / 2, that of r is 2 R / 3.
TEST(ThinLens, IsSampledUniformly) {
  const View view = oblique_view();
  const Camera camera(view, 40, 30);
  Vec3d sum(0);
  double squares = 0;
  double radii = 0;
  double largest = 0;
  constexpr int Count = 4096;
  for (std::uint32_t i = 0; i < Count; ++i) {
    const Vec3d off = Vec3d(camera.ray(7, 9, transport::sobol_point(i, 2).xy()).origin) - view.eye;
    sum += off;
    squares += off.length2();
    radii += off.length();
    largest = std::max(largest, off.length());
  }
  EXPECT_NEAR(sum.length() / Count, 0, 1e-3);
  EXPECT_NEAR(squares / Count, 0.3 * 0.3 / 2, 1e-4);
  EXPECT_NEAR(radii / Count, 2 * 0.3 / 3, 1e-3);
  EXPECT_LE(largest, 0.3 + 1e-6);
}

TEST(ThinLens, IsAPinholeWithoutARadius) {
  View view = oblique_view();
  view.lens_radius = 0;
  const Camera camera(view, 40, 30);
  const Ray pinhole = camera.ray(12, 21);
  const Ray ray = camera.ray(12, 21, {0.9F, 0.2F});
  EXPECT_EQ(ray.origin, pinhole.origin);
  EXPECT_EQ(ray.direction, pinhole.direction);
}

TEST(ThinLens, FocusesOnTheTargetUnlessTold) {
  View view = oblique_view();
  EXPECT_EQ(transport::focus_distance_of(view), 5);
  view.focus_distance = 0;
  EXPECT_FLOAT_EQ(transport::focus_distance_of(view), std::sqrt(35.0F));
}

/// The part of a unit disc on the side of a chord at this signed distance from its centre.
double share_beside(double distance) {
  if (std::abs(distance) >= 1) return distance > 0 ? 0 : 1;
  return (std::acos(distance) - distance * std::sqrt(1 - distance * distance)) / std::numbers::pi;
}

/// The mean of that over an interval.
double mean_share(double from, double to) {
  constexpr int Steps = 1000;
  double sum = 0;
  for (int i = 0; i < Steps; ++i) sum += share_beside(from + (to - from) * (i + 0.5) / Steps);
  return sum / Steps;
}

// The edge of a wall that glows where x < 0 is blurred over the circle of confusion, whose radius at a depth
// d is R |1 - d / f| for the focus distance f.
void expect_blur(double depth) {
  constexpr int Width = 24;
  constexpr float Radius = 0.25F;
  constexpr double Focus = 4;
  const double z = 4 - depth;
  test::RenderSetup setup;
  setup.eye = Vec3f(0, 0, 4);
  setup.width = Width;
  setup.height = Width;
  setup.samples = 1024;
  setup.depth = 0;
  const double blur = Radius * std::abs(1 - depth / Focus);
  setup.field_of_view = static_cast<float>(2 * std::atan(1.5 * blur / depth) * 180 / std::numbers::pi);
  setup.lens_radius = Radius;
  const std::string wall =
      test::quad("light rgb (1,1,1)", fmt::format("(-9,-9,{0}) (0,-9,{0}) (0,9,{0}) (-9,9,{0})", z));
  const image::Image image = test::render(test::scene_of(wall), setup).mean();
  const double pixel = 3.0 / Width;  // in radii of the circle
  double most = 0;
  for (int x = 0; x < Width; ++x) {
    const double left = -1.5 + x * pixel;
    const double expected = mean_share(left, left + pixel);
    most = std::max(most, std::abs(double(image.at(x, Width / 2).x) - expected));
  }
  EXPECT_LT(most, 0.01) << depth;
}

TEST(DepthOfField, BlursAnEdgeAsTheCircleOfConfusionDoes) {
  expect_blur(8);  // behind the plane of focus
  expect_blur(2);  // before it
}

}  // namespace
