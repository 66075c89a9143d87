// The thin lens of the camera, and the depth of field that it makes, against closed forms.
#include "renderer/transport/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

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

/// A square of side 20 about the origin, in the plane of x and y, and where it is placed.
struct Sheet {
  Vec3f scale, angles, offset;

  grf::Matrix44d map() const { return test::map_of(scale, angles, offset); }
  /// The point at these coordinates in its plane.
  Vec3d point(double x, double y) const { return Vec3d(x, y, 0) * map(); }
  Vec3d normal() const { return (point(1, 0) - point(0, 0)).cross(point(0, 1) - point(0, 0)).normalized(); }
  static std::string mesh() {
    return test::quad("brdf diffuse", "(-10,-10,0) (10,-10,0) (10,10,0) (-10,10,0)");
  }
  std::string text() const { return test::placed(mesh(), scale, angles, offset); }
  /// The same, as an instance of a mesh that is placed once more, far away.
  std::string text_of_instances() const {
    return "def sheet = " + mesh() + "begin " + test::placed("use sheet", scale, angles, offset) +
           test::placed("use sheet", Vec3f(1), Vec3f(0), Vec3f(0, 0, 200)) + "end";
  }
};

std::vector<Sheet> tilted_sheets() {
  return {{Vec3f(1), Vec3f(0), Vec3f(0, 0, 3)},
          {Vec3f(1), Vec3f(0.3F, 0.5F, 0.7F), Vec3f(3, 4, 5)},
          {Vec3f(1), Vec3f(1.3F, -0.4F, 2.1F), Vec3f(-7, 0.1F, 2)},
          {Vec3f(0.01F, 0.02F, 1), Vec3f(0.2F, 0.9F, -0.3F), Vec3f(0.3F, 0.7F, -0.2F)},
          {Vec3f(30, 50, 20), Vec3f(-0.8F, 0.1F, 0.6F), Vec3f(90, -40, 10)}};
}

/// The number of camera rays, of 64 within 21 degrees of a direction, that hit something right before the
/// eye.
int rays_that_hit(const transport::CompiledScene& scene, const Vec3d& eye, const Vec3d& towards) {
  View view;
  view.eye = eye;
  view.target = eye + towards;
  view.field_of_view = 30;
  const Camera camera = transport::camera_of(scene, view, 8, 8);
  int hits = 0;
  for (int i = 0; i < 64; ++i) {
    const auto x = static_cast<float>(i % 8) + 0.5F;
    const auto y = static_cast<float>(i / 8) + 0.5F;
    const auto met = scene.caster().intersect(camera.ray(x, y));
    if (met && met->distance < 0.01F) ++hits;
  }
  return hits;
}

TEST(CameraInAFace, DoesNotSeeTheFace) {
  for (const Sheet& sheet : tilted_sheets()) {
    for (const bool is_instance : {false, true}) {
      const auto scene = is_instance ? test::scene_of(sheet.text_of_instances(), test::copies_up_to(0))
                                     : test::scene_of(sheet.text());
      for (int i = 0; i < 100; ++i) {
        const auto place = transport::sobol_point(static_cast<std::uint32_t>(i), 5);
        const Vec3d eye = sheet.point(16.0 * place.x - 8, 16.0 * place.y - 8);
        // Up to 0.3 from the normal, so that the whole image is on one side of the sheet.
        const Vec3d across = (sheet.point(1, 0) - sheet.point(0, 0)).normalized() * (0.6 * place.z - 0.3);
        ASSERT_EQ(rays_that_hit(scene, eye, sheet.normal() + across), 0) << i << is_instance;
        ASSERT_EQ(rays_that_hit(scene, eye, -sheet.normal() + across), 0) << i << is_instance;
      }
    }
  }
}

// The sheets' corners are rounded to about 1e-6 of their coordinates, a camera ray's origin is uncertain by
// several times that; an eye between the two stays on its side.
TEST(CameraInAFace, SeesAFaceThatIsRightBeforeIt) {
  for (const Sheet& sheet : tilted_sheets()) {
    const auto scene = test::scene_of(sheet.text());
    const double size = std::max({(sheet.point(10, 10)).length(), sheet.point(-10, 10).length(),
                                  sheet.point(10, -10).length(), sheet.point(-10, -10).length()});
    for (int i = 0; i < 100; ++i) {
      const auto place = transport::sobol_point(static_cast<std::uint32_t>(i), 5);
      const Vec3d in_face = sheet.point(16.0 * place.x - 8, 16.0 * place.y - 8);
      const Vec3d normal = sheet.normal() * (i % 2 == 0 ? 1 : -1);
      const Vec3d eye = in_face + normal * (6e-7 * size);
      ASSERT_EQ(rays_that_hit(scene, eye, -normal), 64) << i << ' ' << size;
      ASSERT_EQ(rays_that_hit(scene, eye, normal), 0) << i << ' ' << size;
    }
  }
}

// In a corner of a closed room, the eye is moved off three walls, to the inside.
TEST(CameraInAFace, LooksIntoARoomFromItsCorners) {
  const Sheet room = {Vec3f(1, 2, 1.5F), Vec3f(0.3F, 0.5F, 0.7F), Vec3f(3, 4, 5)};
  const auto scene =
      test::scene_of(test::placed(test::box("brdf diffuse"), room.scale, room.angles, room.offset));
  for (int i = 0; i < 8; ++i) {
    const Vec3d corner(i % 2 * 2 - 1, i / 2 % 2 * 2 - 1, i / 4 * 2 - 1);
    View view;
    view.eye = corner * room.map();
    view.target = Vec3d(0) * room.map();
    view.field_of_view = 20;
    const Camera camera = transport::camera_of(scene, view, 8, 8);
    for (int k = 0; k < 64; ++k) {
      const auto point = scene.intersect(camera.ray(static_cast<float>(k % 8), static_cast<float>(k / 8)));
      ASSERT_TRUE(point);
      EXPECT_GT((point->position - Vec3f(view.eye)).length(), 1);
    }
  }
}

}  // namespace
